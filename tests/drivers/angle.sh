#!/usr/bin/env bash
# Puts ANGLE's libEGL and libGLESv2, with SwiftShader, into FOLDER/angle: npm's @sparticuz/chromium carries them, Debian's
# chromium does not.   usage: angle.sh FOLDER
set -euo pipefail
mkdir -p "$1"
cd "$1"
[ -e angle/libEGL.so.1 ] && exit
command -v npm >/dev/null || { echo "ANGLE needs npm (Debian: npm)" >&2; exit 1; }
npm pack --silent @sparticuz/chromium@123.0.1 >/dev/null
rm -rf unpacked
mkdir unpacked
tar -xzf sparticuz-chromium-123.0.1.tgz -C unpacked package/bin/swiftshader.tar.br
node -e 'const fs = require("fs"), bytes = fs.readFileSync("unpacked/package/bin/swiftshader.tar.br");
  fs.writeFileSync("unpacked/swiftshader.tar", require("zlib").brotliDecompressSync(bytes))'
tar -xf unpacked/swiftshader.tar -C unpacked --no-same-owner
ln -s libEGL.so unpacked/libEGL.so.1
ln -s libGLESv2.so unpacked/libGLESv2.so.2
rm -rf unpacked/package unpacked/swiftshader.tar sparticuz-chromium-123.0.1.tgz
mv unpacked angle
