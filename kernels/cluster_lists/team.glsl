// A group is 8 cells, of 32 threads each.
const uint kTeam = 32u, kTeams = 8u;
const uint THREADS = kTeam * kTeams, SCANNED = kTeam;
layout(local_size_x = THREADS) in;
