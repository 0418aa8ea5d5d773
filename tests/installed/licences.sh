#!/usr/bin/env bash
# licences.sh SOURCE BUILD: docs/licences.md lists each library that a binary of BUILD needs, and no
# other; and the origin of each image and mesh of SOURCE.
set -euo pipefail
cd "$1"
build=$2 page=docs/licences.md
fail() { echo "$page: $*" >&2; exit 1; }

needed=$(for binary in "$build"/bin/wrinkle "$build"/bin/wrinkle-editor "$build"/lib/libwrinkle.so \
    "$build"/lib/wrinkle/*.so "$build"/lib/wrinkle/wrinkle-{watch-server,plugin-probe}; do
    readelf -d "$binary"
done | sed -nE 's/.*NEEDED.*\[(.*\.so)[.0-9a-z]*\]/\1/p' | sort -u)
listed=$(sed -nE 's/^\| `([^`]*\.so)` \|.*/\1/p' "$page" | sort -u)
missing=$(comm -23 <(echo "$needed") <(echo "$listed"))
unused=$(comm -13 <(echo "$needed") <(echo "$listed") | grep -v '^ld-linux-' || true)
[ -z "$missing" ] || fail "these libraries are missing:" "$missing"
[ -z "$unused" ] || fail "no program links these libraries:" "$unused"

mapfile -t patterns < <(sed -nE 's/^\| `([^`]*\*)` \|.*/\1/p' "$page")
assets=0
while IFS= read -r file; do
    assets=$((assets + 1)) found=0
    for pattern in "${patterns[@]}"; do
        [[ $file != $pattern ]] || found=1
    done
    [ $found = 1 ] || fail "the origin of $file is missing"
done < <(find graphs plugins docs tests -name build -prune -o -type f -print |
    grep -E '\.(png|jpe?g|glb|gltf|obj|hdr|exr|npy|ttf|otf|mtlx)$')
[ $assets -gt 100 ] || fail "only $assets images and meshes were found"
echo "$(wc -l <<<"$needed") libraries, $assets images and meshes"
