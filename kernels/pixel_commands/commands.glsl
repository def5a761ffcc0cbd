// A tile's waves as commands: as many as it has binary digits set, the large ones first.
UPDATES(5, CommandRow, command_rows);
WRITES(7, uint, commands);

void append_command(uint row, uint wave) {
#ifdef MUTANT_22  // every command takes the row's first place
  const uint at = atomicAdd(command_rows[row].count, 1u) * 0u;
#else
  const uint at = atomicAdd(command_rows[row].count, 1u);
#endif
  commands[command_rows[row].first + at] = wave;
}

void command_waves(uint shader, uint kind, uint wave, uint waves) {
  const uint rows = shader * kCommandRows + kind * kCommandBuckets;
  for (uint end = wave + waves; wave < end;) {
    const uint k = min(findMSB(end - wave), int(kCommandBuckets) - 1);
    append_command(rows + k, wave);
#ifdef MUTANT_23  // each command starts where the first did
    end -= 1u << k;
#else
    wave += 1u << k;
#endif
  }
}
