// From the sum over all pixels to the exposure.
ExposureRecord exposure_of(PartialSum all) {
  ExposureRecord e = ExposureRecord(all.sum, all.counted, kMiddleGrey, 0.0);
  if (all.counted != 0u) {
    e.mean = all.sum / float(all.counted);
    if (params.metering != kMeterMean) e.mean = exp2(e.mean);
  }
#ifdef MUTANT_8  // no end to a black picture's exposure
  e.exposure = kMiddleGrey / e.mean * params.compensation;
#else
  e.exposure = kMiddleGrey / clamp(e.mean, kLeastMean, kGreatestMean) * params.compensation;
#endif
  return e;
}
ExposureRecord manual_exposure() {
#ifdef MUTANT_9  // uncompensated
  return ExposureRecord(0.0, 0u, 0.0, params.manual_exposure);
#else
  return ExposureRecord(0.0, 0u, 0.0, params.manual_exposure * params.compensation);
#endif
}
