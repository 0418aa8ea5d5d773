#!/usr/bin/env bash
# run_embedding.sh PAGE BUILD: carries docs/embedding.md out (carry_out.sh), and sees that the library
# exports nothing but its C and C++ interfaces.
set -euo pipefail
. "$(dirname "$0")/carry_out.sh"
library=$(realpath "$2")/lib/libwrinkle.so
# A library with sanitizers wants a program that has them.
export CXXFLAGS=""
if nm -D "$library" | grep ' U __asan_' >/dev/null; then
    export CXX=clang++ CXXFLAGS="-fsanitize=address,undefined"
fi
carry_out "$@"

readelf -d "$library" | grep -qF "soname: [libwrinkle.so.0.2]" || fail "the soname is another"
shown=$(nm -D -C --defined-only "$library")
[[ $shown == *" T wrinkle::api::Graph::check("* ]] || fail "nm does not show the C++ interface:" "$shown"
foreign=$(grep -vE ' [TW] wrinkle(::api::|_)' <<<"$shown" || true)
[ -z "$foreign" ] || fail "the library shows more than its interfaces:" "$foreign"
echo "$(wc -l <"$here/order") blocks"
