// What a cell holds, within what an entry has room for; the rest is dropped. The offset is place.comp's to give.
UPDATES(4, ClusterListStatus, list_status);

void drop(uvec3 lost) {
  if (lost.x != 0u) atomicAdd(list_status[0].dropped_lights, lost.x);
  if (lost.y != 0u) atomicAdd(list_status[0].dropped_decals, lost.y);
  if (lost.z != 0u) atomicAdd(list_status[0].dropped_probes, lost.z);
}

void store_counts(uint cell, uvec3 found) {
  const uvec3 kept = min(found, most_in_a_cell());
  cells[cell] = uvec2(0u, pack_cluster(kept));
#ifndef MUTANT_3  // what is dropped is not told
  drop(found - kept);
#endif
}
