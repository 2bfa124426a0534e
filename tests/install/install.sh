#!/usr/bin/env bash
# install.sh BUILD ROOT: what `cmake --install` puts into a scratch prefix works after the prefix has moved, with and
# without DESTDIR.
set -euo pipefail
build=$(realpath "$1") root=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  echo "$*" >&2
  exit 1
}
unset DISPLAY WAYLAND_DISPLAY SNELL_WEB

cmake --install "$build" --prefix "$work/first" >"$work/log" || fail "$(tail "$work/log")"
DESTDIR=$work/staged cmake --install "$build" --prefix /opt/snell >"$work/log" || fail "$(tail "$work/log")"
(cd "$work/first" && find . | sort) >"$work/plain"
(cd "$work/staged/opt/snell" && find . | sort) >"$work/destdir"
diff "$work/plain" "$work/destdir" || fail "DESTDIR gives other files"
[ "$(ls "$work/staged")" = opt ] || fail "files outside of DESTDIR/prefix"

for file in bin/snell lib/snell/snell_oiio.so lib/snell/snell_archive.so lib/snell/snell_cairo.so share/snell/scenes/light/glass/glass.glib share/snell/shaders/snell/fresnel.glsl \
  share/doc/snell/README.md share/doc/snell/CHANGELOG.md share/doc/snell/copyright share/doc/snell/docs/language.md \
  share/doc/snell/scenes/light/glass/glass.glib share/applications/snell.desktop share/man/man1/snell.1 share/man/man1/snell-render.1 \
  share/bash-completion/completions/snell share/zsh/vendor-completions/_snell share/fish/vendor_completions.d/snell.fish \
  share/vim/vimfiles/syntax/glib.vim share/vim/vimfiles/compiler/snell.vim share/nvim/site/ftdetect/glib.vim share/doc/snell/docs/editors/glib.tmLanguage.json \
  share/icons/hicolor/scalable/apps/snell.svg share/mime/packages/snell.xml; do
  [ -f "$work/first/$file" ] || fail "'$file' is not installed"
done
! grep -rlF "$root" "$work/first" || fail "these files name the folder of the sources"
! find "$work/first" -type d -empty | grep . || fail "empty folders are installed"

# The links of the pages lead to files.
(cd "$work/first/share/doc/snell" && grep -oHE '\]\([^):#]+' README.md docs/*.md docs/teaching/*.md docs/teaching/*/*.md | sort -u) |
  while IFS=: read -r page link; do
    target=${link#](}
    [[ $target != http* ]] || continue
    [ -e "$work/first/share/doc/snell/$(dirname "$page")/$target" ] || fail "$page: $target is not installed"
  done

mv "$work/first" "$work/moved"
mkdir "$work/user"
cd "$work/user"
snell=$work/moved/bin/snell
"$snell" render "$work/moved/share/snell/scenes/light/glass/glass.glib" -o glass.tif --size 32x32
printf '##OpenGL GLIB\nOrtho -1 1 -1 1\nTexture2D 5 glass.tif\nVertex a.vert\nFragment a.frag\nProgram P uT 5\nQuadXY 0 1\n' >a.glib
printf 'void main() { gl_TexCoord[0] = gl_MultiTexCoord0; gl_Position = gl_Vertex; }\n' >a.vert
printf 'uniform sampler2D uT; void main() { gl_FragColor = texture2D(uT, gl_TexCoord[0].st); }\n' >a.frag
"$snell" render "$work/moved/share/snell/scenes/light/glass/glass.glib" -o glass.png --size 32x32
"$snell" render a.glib -o a.png --size 32x32 >log 2>&1 && [ ! -s log ] || fail "a scene with a TIFF texture: $(cat log)"
cmp a.png glass.png || fail "the texture is not what was drawn"
mv "$work/moved/lib/snell" "$work/elsewhere"
! "$snell" render a.glib -o b.png >log 2>&1 || fail "a TIFF was read without the module"
mv "$work/elsewhere" "$work/moved/lib/snell"

web=$work/moved/share/snell/web
if [ ! -f "$web/page.html" ]; then # ./dev web has not built it: its form is enough for the program
  ! "$snell" web a.glib -o a.html >log 2>&1 && grep -qF "there is no '$web/page.html'" log || fail "snell web: $(cat log)"
  mkdir -p "$web"
  echo '<title>snell</title><script type="application/json" id="scene">null</script><script type="text/plain" id="archive"></script>' >"$web/page.html"
fi
"$snell" web a.glib -o a.html >log 2>&1 || fail "snell web: $(cat log)"
grep -q '<title>a</title>' a.html || fail "the page has another title"

if command -v desktop-file-validate >/dev/null; then desktop-file-validate "$work/moved/share/applications/snell.desktop"; fi
if command -v update-mime-database >/dev/null; then
  update-mime-database "$work/moved/share/mime" >log 2>&1
  grep -qxF 'text/x-glib:*.glib' "$work/moved/share/mime/globs" || fail "*.glib has no MIME type"
fi
version=$(sed -n 's/^project(snell VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
[ "$("$snell" --version)" = "snell $version" ] || fail "--version is not $version"
grep -qE "^## $version( |\$)" "$work/moved/share/doc/snell/CHANGELOG.md" || fail "CHANGELOG.md has no section for $version"
echo "$(wc -l <"$work/plain") files and folders are installed, and work elsewhere"
