// The words of `chain`, which is cleared before: two of the whole, the commands of each row, then of each shader and tile
// the sums of pixels and waves, in bits 0..29, and above what they are sums of. Sums stay below 2^28.
const uint kChainNextTile = 0u;
const uint kChainGaveUp = 1u;
const uint kChainDigits = 2u;
uint chain_sums() { return kChainDigits + shader_slots() * kOverflowRow; }
