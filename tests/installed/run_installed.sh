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

# 9 languages in their default, 7 in shader, 8 in function, 2 for the viewer.
mapfile -t rivets < <(printf 'rivet\n%.0s' {1..26})
expect rivet rivet strap "${rivets[@]}"
"$here/build/viewer" || fail "the shader is not there"
for file in materials/strap.glsl materials/strap.reflection.json materials/rivet.glsl shaders/rivet.vert \
    shaders/rivet.frag.spv shaders/rivet.vert.hlsl; do
    [ -s "$here/build/$file" ] || fail "$file is not there"
done
# The project writes down what wrinkle_compile() promised; Ninja would build again what is not there.
[ "$(wc -l <"$here/build/made.txt")" -eq 32 ] || fail "$(cat "$here/build/made.txt")"
while read -r file; do
    [ -s "$file" ] || fail "$file is not there"
done <"$here/build/made.txt"
listed=$("$here/prefix/bin/wrinkle" compile --list-targets | cut -d' ' -f1)
for language in $listed; do
    grep -q "/${language}_default/" "$here/build/made.txt" || fail "CMake has not heard of $language"
done
for file in spirv_shader/rivet.vert.spv spirv_default/rivet.frag.spv hlsl_shader/rivet.vert.hlsl \
    hlsl_default/rivet.hlsl msl_shader/rivet.frag.msl godot4_default/rivet.gdshaderinc essl300_default/rivet.glsl glsl450_shader/rivet.frag; do
    grep -q "/$file\$" "$here/build/made.txt" || fail "$file is not promised"
done
[ "$(head -c 4 "$here/build/spirv_default/rivet.frag.spv" | od -An -tx4 | tr -d ' ')" = 07230203 ] ||
    fail "rivet.frag.spv is no SPIR-V"
head -n 1 "$here/build/essl300_shader/rivet.frag" | grep -q '#version 300 es' || fail "not ES"

# refuses WORDS...: wrinkle_compile(TARGET t GRAPHS parts/rivet.json WORDS...) stops the configuration.
refuses() {
    printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(Refused LANGUAGES NONE)' \
        'find_package(Wrinkle REQUIRED)' "wrinkle_compile(TARGET t GRAPHS strap.json $*)" \
        >"$here/refused.txt"
    rm -rf "$here/refused" && mkdir "$here/refused" && mv "$here/refused.txt" "$here/refused/CMakeLists.txt"
    ! cmake -G Ninja -S "$here/refused" -B "$here/refused/build" -DCMAKE_PREFIX_PATH="$here/prefix" \
        >"$here/log" 2>&1 || fail "took $*"
    grep -q wrinkle_compile "$here/log" || fail "$(cat "$here/log")"
}
refuses LANGUAGE pascal
refuses LANGUAGE spirv FORM function
refuses LANGUAGE godot3 FORM shader
refuses FORM poem
refuses OPTIONS --target hlsl

expect ''
sed -i 's/0.5/0.75/' "$here/project/strap.json"
expect strap
grep -q 0.75 "$here/build/materials/strap.reflection.json" || fail "the change did not come through"
touch "$here/project/parts/rivet.json"
expect rivet rivet strap "${rivets[@]}"
expect ''

# The manual is found and read.
[ -s "$here/prefix/share/man/man1/wrinkle-compile.1" ] || fail "the manual is not there"
echo "installed"
