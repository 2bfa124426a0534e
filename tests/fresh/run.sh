#!/usr/bin/env bash
# run.sh [root] [user]: ./dev run and ./dev test in a minimal Debian 12, in a clone of what is committed here: as root without
# a locale, as a user with sudo with the locale POSIX, or both (the default).
# Mirrors, proxies and keys are those of this machine's apt. Compiled objects are kept in build/fresh, for the
# next run.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# Mounts and processes of the run end with the namespace.
if [ -z "${SNELL_FRESH_NAMESPACE:-}" ]; then
  as_root=()
  [ "$(id -u)" = 0 ] || as_root=(sudo -E)
  exec "${as_root[@]}" env SNELL_FRESH_NAMESPACE=1 unshare --mount --pid --fork --kill-child "$PWD/tests/fresh/run.sh" "$@"
fi

clone=$PWD
kept=$clone/build/fresh
work=$(mktemp -d)
trap 'umount -lR "$work"/*/{proc,dev,sys} "$work"/*/var/ccache 2>/dev/null || true; rm -rf --one-file-system "$work"' EXIT
mkdir -p "$kept"
chmod 777 "$kept"  # the user may be the first

source "$clone/tests/fresh/apt.sh" "$work"

# machine USER LOCALE-SETTING...: a new machine, and the two commands in it.
machine() {
  local who=$1 home=/root machine=$work/$1 run=() include=ca-certificates
  shift
  if [ "$who" = user ]; then
    home=/home/user
    run=(runuser -u user --)
    include+=,sudo
  fi
  echo "== $who: a minimal Debian" >&2
  mmdebstrap --quiet --variant=minbase --include="$include" --aptopt="$work/apt.conf" bookworm "$machine" "${sources[@]}"
  cp /etc/hosts "$machine/etc/hosts"
  git clone --quiet --no-hardlinks "file://$clone" "$machine$clone"
  if [ "$who" = user ]; then
    chroot "$machine" useradd --create-home user
    echo 'user ALL=(ALL) NOPASSWD: ALL' >"$machine/etc/sudoers.d/user"
    chroot "$machine" chown -R user: "$clone"
  fi
  mkdir -p "$machine/var/ccache"
  mount --bind "$kept" "$machine/var/ccache"
  mount -t proc proc "$machine/proc"
  mount --rbind /sys "$machine/sys"
  mount --rbind /dev "$machine/dev"
  mount -t tmpfs -o mode=1777 tmpfs "$machine/dev/shm"
  for command in run test; do
    echo "== $who: ./dev $command" >&2
    chroot "$machine" "${run[@]}" env -i PATH=/usr/local/bin:/usr/bin:/bin:/usr/sbin:/sbin HOME="$home" \
      CCACHE_DIR=/var/ccache CCACHE_UMASK=000 "$@" bash -c "cd '$clone' && ./dev $command"
  done
}

[ $# -gt 0 ] || set -- root user
for who in "$@"; do
  case $who in
    root) machine root ;;
    user) machine user LC_ALL=POSIX ;;
    *) sed -n '2,5s/^# //p' "$0" >&2; exit 2 ;;
  esac
  echo "$who: both commands end with 0"
done
