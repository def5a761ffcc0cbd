// When pixels of different triangles may share: the three rules of Fuller and Hammer, in whole numbers.
#pragma once
#include "harness/vrcs_oracle.h"
#include "kernels/vrcs_coordinates/layout.h"

namespace assay::vrcs_coordinates {

vrcs::Sharing same_surface(const Case&);
vrcs::Sharing stored_normal(const Case&);
vrcs::Sharing rebuilt_normal(const Case&);

}  // namespace assay::vrcs_coordinates
