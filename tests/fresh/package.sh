#!/usr/bin/env bash
# package.sh PACKAGE.deb: installs the package in a minimal Debian 12, and there, as a user without rights: renders a scene,
# makes a scene of the user's own, opens it in a window under Xvfb, grades a lesson, reads manual pages, completes words, and
# opens a scene in Neovim. Before that, lintian finds no error in the package.
# Mirrors, proxies and keys are those of this machine's apt.
set -euo pipefail
package=$(realpath "$1")
if [ -z "${SNELL_FRESH_NAMESPACE:-}" ]; then
  as_root=()
  [ "$(id -u)" = 0 ] || as_root=(sudo -E)
  exec "${as_root[@]}" env SNELL_FRESH_NAMESPACE=1 unshare --mount --pid --fork --kill-child "$(realpath "$0")" "$package"
fi
lintian --allow-root --fail-on error "$package"
work=$(mktemp -d)
machine=$work/machine
trap 'umount -lR "$machine"/{proc,dev,sys} 2>/dev/null || true; rm -rf --one-file-system "$work"' EXIT
source "$(dirname "$(realpath "$0")")/apt.sh" "$work"

echo "== a minimal Debian" >&2
mmdebstrap --quiet --variant=minbase --include=ca-certificates --aptopt="$work/apt.conf" bookworm "$machine" "${sources[@]}"
cp /etc/hosts "$machine/etc/hosts"
mount -t proc proc "$machine/proc"
mount --rbind /sys "$machine/sys"
mount --rbind /dev "$machine/dev"
mount -t tmpfs -o mode=1777 tmpfs "$machine/dev/shm"
chroot "$machine" useradd --create-home user
cp "$package" "$machine/tmp/"
inside() { chroot "$machine" env -i PATH=/usr/local/bin:/usr/bin:/bin:/usr/sbin:/sbin HOME=/root DEBIAN_FRONTEND=noninteractive "$@"; }
user() { chroot "$machine" runuser -u user -- env -i PATH=/usr/local/bin:/usr/bin:/bin HOME=/home/user bash -c "cd && $1"; }

echo "== apt install ./$(basename "$package")" >&2
inside apt-get update -qq
inside apt-get install -y -qq --no-install-recommends "/tmp/$(basename "$package")" >"$work/install.log" 2>&1 ||
  { tail -20 "$work/install.log" >&2; exit 1; }
user 'snell --version && snell info'
user 'snell render /usr/share/snell/scenes/refraction-room/refraction-room.glib -o room.png --size 320x240'
user 'snell render /usr/share/snell/scenes/light/glass/glass.glib -o glass.tif --size 64x64'
user '[ "$(head -c 4 room.png | tail -c 3)" = PNG ] && [ "$(stat -c %s room.png)" -gt 20000 ]'

echo "== a window under Xvfb" >&2
inside apt-get install -y -qq --no-install-recommends xvfb xauth xdotool x11-utils man-db >"$work/install.log" 2>&1
user 'snell new glass | tee new && snell check --grade glass/glass.glib && snell format --check glass/glass.glib'
user 'grep -q "^open it: snell glass/glass.glib$" new'
# Each opens a window that has the name of the scene in its title, and does not end by itself.
cat >"$machine/tmp/windows.sh" <<'END'
for scene in glass/glass.glib glass /usr/share/snell/scenes/refraction-room/refraction-room.glib; do
  snell "$scene" >log 2>&1 & window=$!
  for i in $(seq 60); do
    id=$(xdotool search --onlyvisible --class snell 2>/dev/null | head -1) && [ -n "$id" ] && break
    kill -0 $window || { cat log; exit 1; }
    sleep 1
  done
  name=${scene##*/}
  sleep 3
  xprop -id "$id" WM_CLASS WM_NAME | tee title
  grep -q "${name%.glib}.glib" title && kill -0 $window || { cat log; exit 1; }
  kill $window
  wait $window || true
done
END
user 'xvfb-run -a bash -e /tmp/windows.sh'

echo "== a lesson, with a submission in an archive" >&2
user 'cp -r /usr/share/doc/snell/docs/teaching/01-colour lesson && cd lesson/submissions && tar czf late.tar.gz passing &&
  cd .. && snell grade rubric.toml submissions -o out/report && [ "$(grep -c ,10, out/report/results.csv)" = 2 ]'

echo "== manual pages and completion" >&2
for page in snell snell-render snell-new snell-lsp; do
  user "man $page >page && grep -q ^NAME page && grep -q '$page - ' page"
done
# As bash does it for a Tab behind --set uI.
user 'source /usr/share/bash-completion/completions/snell
  for scene in /usr/share/snell/scenes/refraction-room/refraction-room.glib glass/glass.glib; do
    COMP_WORDS=(snell render $scene --set uI) COMP_CWORD=4 COMPREPLY=()
    _snell
    [ "${COMPREPLY[*]}" = uIndex= ] || { echo "$scene: ${COMPREPLY[*]}"; exit 1; }
  done'
echo "== Neovim" >&2
inside apt-get install -y -qq --no-install-recommends neovim >"$work/install.log" 2>&1
user 'nvim --headless +"edit glass/glass.glib" +"set filetype?" +quit 2>&1 | grep -q filetype=glib'
inside apt-get remove -y -qq snell >"$work/install.log" 2>&1
! inside ls /usr/lib/snell /usr/share/snell 2>/dev/null || { echo "files stay behind" >&2; exit 1; }
echo "$(basename "$package") installs, renders, opens a window and is removed without a rest"
