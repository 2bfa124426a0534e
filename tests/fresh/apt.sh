# apt.sh WORK, to be sourced: writes WORK/apt.conf, what apt needs to know of this network, and sets `sources`, the lists of
# Debian 12.
apt-config --format '%F "%v";%n' dump | grep '^Acquire::' >"$1/apt.conf" || true
for scheme in http https; do
  proxy=${scheme}_proxy
  [ -z "${!proxy:-}" ] || printf 'Acquire::%s::Proxy "%s";\n' "$scheme" "${!proxy}" >>"$1/apt.conf"
done
shopt -s nullglob
sources=()
for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources}; do
  ! grep -qs bookworm "$list" || sources+=("$list")
done
