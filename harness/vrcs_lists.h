// The lists of variable-rate compute shading as a pass over them finds them: what each lane shades, and where that is
// stored (Fuller, Hammer 2025, VRCSPrefix and VRCSPostFix). For the oracles of such passes and for their generators.
// Host only.
#pragma once
#include <optional>

#include "harness/formats/workloads.h"
#include "harness/oracle.h"
#include "harness/vrcs_oracle.h"

namespace assay::vrcs {

// A pixel of the screen that is shaded.
struct Work {
  uint x, y;
  uint copies = 0;   // kCopyHorizontal, ...
  uint depth = 0;    // of an entry with depth its code
  bool own = false;  // all of the tile is shaded: the lane's own pixel, which may have no surface
};
// Each pixel of the screen that it is stored to: f(x, y).
template <class F>
void for_each_store(Extent e, const Work& w, F f) {
  const auto store = [&](uint x, uint y) {
    if (x < e.width && y < e.height) f(x, y);
  };
  store(w.x, w.y);
  if (w.copies & kCopyHorizontal) store(w.x ^ 1, w.y);
  if (w.copies & kCopyVertical) store(w.x, w.y ^ 1);
  if (w.copies & kCopyDiagonal) store(w.x ^ 1, w.y ^ 1);
}

struct TileLists {
  Extent extent = {};
  std::span<const uint> tiles = {}, entries = {};
  uint frame = 0;
};
// Nothing for a lane without work. lane: 0 to 255; fog: the pass shades all of fogged tiles.
std::optional<Work> work_of(const TileLists&, uint tile, uint lane, bool fog = false);

struct ScreenList {
  Extent extent = {};
  std::span<const uint> entries = {};
  uint count = 0;
  DispatchArgs args = {};  // of groups of kVrcsListGroup threads
};
ScreenList screen_list(const Case&);    // the inputs `list`, `list_count`, `list_args`
uint entries_taken(const ScreenList&);  // no more than there is room for, nor than threads are dispatched
std::optional<Work> work_of(const ScreenList&, uint i);

// Sets these inputs, the tiles in any order.
void set_screen_list(Case&, const std::vector<Tile>&, Pcg32&);

// With an input's words changed: lists that are nobody's.
Case changed(Case, const std::string& input, const std::function<void(std::vector<uint>&)>& change);

}  // namespace assay::vrcs
