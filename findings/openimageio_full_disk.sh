#!/bin/bash
# Packages: libopenimageio2.4 and libopenimageio-dev 2.4.7.1+dfsg-2, in front of the libraries of Debian 12 that they stand on.
# What happens: where a file finds no room (here: a limit to the size of files, whose signal is ignored), open, write_image and close of ImageOutput all return true and geterror() is empty: for GIF, FITS, SGI
#   and WebP wherever the room ends, for PNG, EXR, Radiance HDR and PNM where it ends in the last bytes, which wait in a buffer until close(). The file ends where the room did. TIFF says so in both cases.
# Why one expects something else: the functions return whether they were done, close() is where a buffer goes to the disk, and a write that fails in the middle of a PNG is told: one that tries
#   a full disk once, with a large picture, finds nothing wrong.
# What it means: a program that writes beside an old picture and renames when close() returned true replaces it by the head of one. pxm gives the writers a place to write to that remembers the first
#   failure, and reads back what those write that take none (host/output/library_encoder.cpp).
# Seen on 2026-11-30:
#   gif, room for 100 bytes: told as done, is whole              1 0
#   fits, room for 100 bytes: told as done, is whole             1 0
#   sgi, room for 100 bytes: told as done, is whole              1 0
#   webp, room for 100 bytes: told as done, is whole             1 0
#   png, room for all but 100 bytes: told as done, is whole      1 0
#   hdr, room for all but 100 bytes: told as done, is whole      1 0
#   ppm, room for all but 100 bytes: told as done, is whole      1 0
#   exr, room for all but 100 bytes: told as done, is whole      1 0
#   tif: told as done, where the room is too small               0 0
#   holds
source "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

fetch libopenimageio2.4=2.4.7.1+dfsg-2 libopenimageio-dev=2.4.7.1+dfsg-2
cat >"$work/full.cpp" <<'CPP'
#include <OpenImageIO/imageio.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

// Writes 64x48 pixels of noise where a file has room for so many bytes: whether it is told as done.
int main(int, char** argv) {
    using namespace OIIO;
    const std::string file = argv[1];
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit room{std::stoul(argv[2]), std::stoul(argv[2])};
    setrlimit(RLIMIT_FSIZE, &room);
    std::vector<unsigned char> pixels(64 * 48 * 3);
    for (unsigned char& byte : pixels) byte = static_cast<unsigned char>(std::rand() >> 7);
    auto output = ImageOutput::create(file);
    bool written = output->open(file, ImageSpec(64, 48, 3, TypeDesc::UINT8)) &&
                   output->write_image(TypeDesc::UINT8, pixels.data());
    written = output->close() && written && output->geterror().empty();
    std::printf("%d\n", written);
}
CPP
lib=$work/root/usr/lib/x86_64-linux-gnu
g++ -w -std=c++17 -I"$work/root/usr/include" -o "$work/full" "$work/full.cpp" -L"$lib" -lOpenImageIO -lOpenImageIO_Util >"$work/log" 2>&1 || {
    tail -5 "$work/log" >&2
    echo "not tried: the libraries that OpenImageIO stands on are not there" >&2
    exit 77
}
# try FORMAT ROOM: whether it is told as done, and the bytes of the file.
try() {
    local told
    rm -f "$work/a.$1"
    told=$(LD_LIBRARY_PATH=$lib "$work/full" "$work/a.$1" "$2" 2>/dev/null) || true
    echo "${told:-0} $(stat -c %s "$work/a.$1")"
}
# short FORMAT SPARED: the same with room for all but so many bytes (or, below 0, for so many), and whether the file is whole.
short() {
    local whole told size
    read -r _ whole < <(try "$1" 1000000)
    read -r told size < <(try "$1" $(($2 < 0 ? -$2 : whole - $2)))
    echo "$told $((size == whole))"
}

for format in gif fits sgi webp; do
    same "$format, room for 100 bytes: told as done, is whole" "$(short $format -100)" "1 0"
done
for format in png hdr ppm exr; do
    same "$format, room for all but 100 bytes: told as done, is whole" "$(short $format 100)" "1 0"
done
same "tif: told as done, where the room is too small" \
    "$(for spared in -100 100; do short tif $spared | cut -d' ' -f1; done | xargs)" "0 0"
holds
