#!/usr/bin/env bash
# compile_shader.sh GLSLANG SPIRV_VAL ROOT KERNEL SHADER ID OUT: GLSL to a C++ table of SPIR-V words, one entry as
# written and one for every MUTANT_n that the shader or a file it includes mentions; OUT.d lists what it read.
set -euo pipefail
glslang=$1 spirv_val=$2 root=$3 kernel=$4 shader=$5 id=$6 out=$7
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Debian 12's glslang has no preamble option: a copy whose second line switches #include on, and whose lines keep their
# numbers and name.
copy=$work/$(basename "$shader")
{
  head -n 1 "$shader"
  echo '#extension GL_GOOGLE_include_directive : require'
  echo "#line 2 \"$shader\""
  tail -n +2 "$shader"
} >"$copy"

compile() { # MUTANT EXTRA...
  local spv=$work/$1.spv
  shift
  "$glslang" -V --target-env vulkan1.3 --quiet -I"$root" "$@" -o "$spv" "$copy" ||
    { echo "$shader: does not compile" >&2; exit 1; }
  "$spirv_val" --target-env vulkan1.3 --scalar-block-layout "$spv"
}

compile 0 --depfile "$work/d"
sed -i "s|$copy|$shader|" "$work/d"
sed "s|^[^:]*:|$out:|" "$work/d" >"$out.d"
mapfile -t read < <(sed 's/^[^:]*://; s/\\$//' "$work/d" | tr ' ' '\n' | grep . | sort -u)
mapfile -t mutants < <(cat "$shader" "${read[@]}" | grep -oE '\bMUTANT_[0-9]+' | sed 's/MUTANT_//' | sort -un)
# Of shared shader code (numbers above 9000) only the faults that the kernel lists.
mapfile -t listing < <(grep -lE '", 9[0-9]{3},' "$(dirname "$shader")"/*.cpp)
((${#listing[@]} == 0)) || echo "$out: ${listing[*]}" >>"$out.d"
listed=()
for n in "${mutants[@]}"; do
  ((n < 9000)) || grep -qw -- "$n" "${listing[@]}" /dev/null || continue
  listed+=("$n")
  compile "$n" "-DMUTANT_$n"
done

{
  echo '#include "harness/device/shader.h"'
  for n in 0 "${listed[@]}"; do
    echo "static const uint32_t words_$n[] = {"
    od -An -v -tx4 -w32 "$work/$n.spv" | sed -E 's/ ([0-9a-f]{8})/0x\1,/g'
    echo '};'
  done
  echo 'static const assay::device::Shader table[] = {'
  for n in 0 "${listed[@]}"; do echo "    {\"$kernel\", \"$(basename "$shader")\", $n, words_$n},"; done
  echo '};'
  echo "extern const std::span<const assay::device::Shader> $id;"
  echo "const std::span<const assay::device::Shader> $id = table;"
} >"$out"
