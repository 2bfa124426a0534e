#!/usr/bin/env python3
"""The files of a page, by another path than the page's own: unpack_page.py PAGE FOLDER

Each file gets its name in the folder; the pixels of an image that is there twice get NAME.decoded. The data of the
scene is in page.json.
"""

import base64
import gzip
import json
import pathlib
import re
import sys


def restored(bytes_, begin, pixel, row):
    """A BMP image, each byte of whose pixels is less what its neighbours foretell, as in PNG."""
    first = row + pixel
    out = bytearray(first) + bytes_[begin:]
    for i in range(first, len(out)):
        left, above, corner = out[i - pixel], out[i - row], out[i - first]
        by_left, by_above, by_corner = abs(above - corner), abs(left - corner), abs(left + above - 2 * corner)
        guess = left if by_left <= min(by_above, by_corner) else above if by_above <= by_corner else corner
        out[i] = (out[i] + guess) % 256
    return bytes_[:begin] + bytes(out[first:])


def main():
    page, folder = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"), pathlib.Path(sys.argv[2])
    block = r'<script type="%s" id="%s">([^<]*)</script>'
    scene, = re.findall(block % ("application/json", "scene"), page)
    archive, = re.findall(block % ("text/plain", "archive"), page)
    header, _, rest = gzip.decompress(base64.b64decode(archive, validate=True)).partition(b"\n")
    for entry in json.loads(header)["files"]:
        name = entry["name"]
        assert not name.startswith("/") and ".." not in name.split("/"), name
        file = folder / (name + (".decoded" if entry["decoded"] else ""))
        file.parent.mkdir(parents=True, exist_ok=True)
        assert not file.exists(), name
        bytes_ = rest[:entry["size"]]
        file.write_bytes(restored(bytes_, *entry["rows"]) if "rows" in entry else bytes_)
        rest = rest[entry["size"]:]
    assert rest == b""
    (folder / "page.json").write_text(json.dumps(json.loads(scene)))


if __name__ == "__main__":
    main()
