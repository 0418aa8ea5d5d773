#!/usr/bin/env bash
# run_packages.sh SOURCE BUILD: makes the Debian packages of BUILD, installs them on a bare Debian that
# debootstrap makes, uses them there, and removes them. Needs root and a mirror of Debian.
set -euo pipefail
source=$(realpath "$1") build=$(realpath "$2")
here=$(mktemp -d /var/tmp/wrinkle-packages.XXXX)
root=$here/root
finish() {
    for mounted in "$root/proc" "$root/dev"; do
        ! mountpoint -q "$mounted" || umount -l "$mounted"
    done
    rm -rf --one-file-system "$here"
}
trap finish EXIT
fail() { echo "packages: $*" >&2; exit 1; }

cpack --config "$build/CPackConfig.cmake" -B "$here/packages" >"$here/log" 2>&1 || fail "$(cat "$here/log")"
lintian --fail-on error "$here"/packages/*.deb || fail "lintian finds errors"

mirror=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null |
    sed -nE 's,^(deb|URIs:) +(\[[^]]*\] +)?(https?:[^ ]*/debian)/?( .*)?$,\3,p' | head -n 1) || true
debootstrap --variant=minbase bookworm "$root" "${mirror:-http://deb.debian.org/debian}" \
    >"$here/log" 2>&1 || fail "$(tail "$here/log")"
mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev" && mount --make-rslave "$root/dev"
cp /etc/resolv.conf "$root/etc/" 2>/dev/null || true
cp /etc/apt/apt.conf.d/*prox* "$root/etc/apt/apt.conf.d/" 2>/dev/null || true
inside() { DEBIAN_FRONTEND=noninteractive chroot "$root" "$@" >"$here/log" 2>&1 || fail "$* fails:" "$(tail -n 30 "$here/log")"; }
files() { (cd "$root" && find . -xdev \( -path ./var -o -path ./proc \) -prune -o -ipath '*wrinkle*' -print | sort); }

inside apt-get install -y --no-install-recommends cmake g++ make pkg-config xvfb xauth libgl1-mesa-dri libegl1
cp "$here"/packages/*.deb "$root/tmp/"
inside bash -c 'apt-get install -y --no-install-recommends /tmp/*.deb'
[ -n "$(files)" ] || fail "nothing is installed"

# As a user: programs, samples, the editor, a plugin, a program in C, Python.
cp "$source/docs/c-library.md" "$root/tmp/"
cat >"$root/tmp/use.sh" <<'USE'
set -euo pipefail
mkdir /tmp/use && cd /tmp/use
cp -r /usr/share/wrinkle/graphs/textures /usr/share/wrinkle/graphs/woven_strap.json .
wrinkle check woven_strap.json
wrinkle compile woven_strap.json -o strap.glsl
wrinkle render woven_strap.json -o strap.png
wrinkle export woven_strap.json --to gltf --size 64 -o strap
wrinkle compile woven_strap.json --target spirv -o strap
xvfb-run -a wrinkle-editor woven_strap.json --shot window.png
test -s strap.glsl && test -s strap.png && test -s window.png && test -s strap.frag.spv
wrinkle new-plugin my_node
cmake -S my_node -B my_node/build && cmake --build my_node/build
wrinkle plugins --test "$(find my_node -name '*.so' | head -n 1)"
awk '/^```c metal.c/ { on = 1; next } /^```/ { on = 0 } on' /tmp/c-library.md >metal.c
awk '/^```json metal.json/ { on = 1; next } /^```/ { on = 0 } on' /tmp/c-library.md >metal.json
cc metal.c $(pkg-config --cflags --libs wrinkle) -o metal
./metal
python3 -c 'import wrinkle; print(wrinkle.Library().load("metal.json").compile().source)'
USE
inside bash /tmp/use.sh
[ -e "$root/usr/share/man/man1/wrinkle-bake.1.gz" ] || fail "a manual page is missing"
[ -e "$root/usr/share/bash-completion/completions/wrinkle" ] || fail "the completion is missing"

rm -rf "$root"/tmp/*
inside apt-get purge -y wrinkle libwrinkle-dev
[ -z "$(files)" ] || fail "these files stay:" "$(files)"
echo "installed, used and removed"
