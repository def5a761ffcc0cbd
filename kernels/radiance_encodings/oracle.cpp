#include "kernels/radiance_encodings/oracle.h"

#include "harness/radiance_oracle.h"

namespace assay::radiance_encodings {

uint32_t encoding_of(const std::string& variant) {
  return variant == "rgb9e5" ? kLightRgb9e5 : variant == "rgba16f" ? kLightRgba16 : kLightR11G11B10;
}

Answer round_trips(const Case& c) {
  Answer answer;
  for (const std::string& name : kEncodings) {
    std::vector<uvec2> codes;
    std::vector<vec3> decoded;
    for (const vec3& colour : c.input<vec3>("colours")) {
      codes.push_back(radiance::encoded(glm::dvec3(colour), encoding_of(name)));
      decoded.emplace_back(radiance::decoded(codes.back(), encoding_of(name)));
    }
    answer[name + " codes"] = expect_all(codes);
    answer[name + " decoded"] = expect_all(decoded);
  }
  return answer;
}

}  // namespace assay::radiance_encodings
