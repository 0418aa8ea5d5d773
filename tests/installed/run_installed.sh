#!/usr/bin/env bash
# run_installed.sh PROJECT BUILD: installs BUILD, builds PROJECT against it with Ninja, and sees what is
# built again after a change.
set -euo pipefail
project=$(realpath "$1") build=$(realpath "$2")
here=$(mktemp -d)
trap 'rm -rf "$here"' EXIT
fail() { echo "installed: $*" >&2; exit 1; }

cmake --install "$build" --prefix "$here/prefix" >"$here/log" 2>&1 || fail "$(cat "$here/log")"
cp -r "$project" "$here/project"
cmake -G Ninja -S "$here/project" -B "$here/build" -DCMAKE_PREFIX_PATH="$here/prefix" \
    >"$here/log" 2>&1 || fail "$(cat "$here/log")"

# expect WORDS...: builds; these graphs and no others are compiled.
expect() {
    sleep 0.02  # dates go in steps
    ninja -C "$here/build" >"$here/log" 2>&1 || fail "$(cat "$here/log")"
    local made wanted
    made=$(sed -n 's/.*Compiling \(.*\) with Wrinkle.*/\1/p' "$here/log" | sort | tr '\n' ' ')
    wanted=$(printf '%s\n' "$@" | sort | tr '\n' ' ')
    [ "${made% }" = "${wanted% }" ] || fail "made '$made' in place of '$wanted'" "$(cat "$here/log")"
}

expect rivet rivet strap
"$here/build/viewer" || fail "the shader is not there"
for file in materials/strap.glsl materials/strap.reflection.json materials/rivet.glsl shaders/rivet.vert; do
    [ -s "$here/build/$file" ] || fail "$file is not there"
done
expect ''
sed -i 's/0.5/0.75/' "$here/project/strap.json"
expect strap
grep -q 0.75 "$here/build/materials/strap.reflection.json" || fail "the change did not come through"
touch "$here/project/parts/rivet.json"
expect rivet rivet strap
expect ''

# The manual is found and read.
[ -s "$here/prefix/share/man/man1/wrinkle-compile.1" ] || fail "the manual is not there"
echo "installed"
