#!/bin/bash
# Packages: libopenimageio2.4 and libopenimageio-dev 2.4.7.1+dfsg-2, in front of the libraries of Debian 12 that they stand on (libtiff6 4.5.0).
# What happens: ImageOutput of TIFF says that it supports "ioproxy". Given one, and a picture that says "oiio:ColorSpace" is "sRGB", open, write_image and close all return true,
#   and the file has no width, no length and no pixels that anything finds: its first directory holds the offset of the Exif directory and one entry more. OpenImageIO cannot read it either.
# Why one expects something else: the same picture with the same attributes written by name is right, so is the same picture through the same proxy without that attribute, so are PNG, EXR, JPEG
#   and eight other formats through the proxy with it, and the proxy (OpenImageIO's own IOFile) can read and seek. The attribute makes the writer add an Exif directory and then go back to
#   the picture's directory, which libtiff has to read from the file; the writer's functions for a proxy read nothing and say so to libtiff only.
# What it means: support for a proxy has to be tried format by format with the attributes that one sets, not asked for. pxm checks every write of its pictures through a proxy, but writes TIFF by
#   name and reads it back (host/output/image.cpp).
# Seen on 2026-11-30:
#   by name: written, read again                                 1 1 64 48
#   through a proxy, no colour space: written, read again        1 1 64 48
#   through a proxy, sRGB: written, read again                   1 0 0 0
#   PNG through a proxy, sRGB: written, read again               1 1 64 48
#   holds
source "$(dirname "${BASH_SOURCE[0]}")/packages.sh"

fetch libopenimageio2.4=2.4.7.1+dfsg-2 libopenimageio-dev=2.4.7.1+dfsg-2
cat >"$work/tiff.cpp" <<'CPP'
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstdio>
#include <string>
#include <vector>

// Writes 64x48 grey pixels and reads them again: whether it was written, whether it can be read,
// and the size that is found. Arguments: file, "proxy" or "name", colour space or "-".
int main(int, char** argv) {
    using namespace OIIO;
    const std::string file = argv[1], way = argv[2], space = argv[3];
    ImageSpec spec(64, 48, 3, TypeDesc::UINT8);
    if (space != "-") spec.attribute("oiio:ColorSpace", space);
    const std::vector<unsigned char> pixels(64 * 48 * 3, 100);
    bool written = false;
    {
        Filesystem::IOFile place(way == "proxy" ? file : file + ".unused", Filesystem::IOProxy::Write);
        auto output = ImageOutput::create(file);
        if (way == "proxy" && !(output->supports("ioproxy") && output->set_ioproxy(&place))) return 1;
        written = output->open(file, spec) && output->write_image(TypeDesc::UINT8, pixels.data());
        written = output->close() && written;
    }
    const auto input = ImageInput::open(file);
    if (!input) geterror();
    std::printf("%d %d %d %d\n", written, input != nullptr, input ? input->spec().width : 0,
                input ? input->spec().height : 0);
}
CPP
lib=$work/root/usr/lib/x86_64-linux-gnu
g++ -w -std=c++17 -I"$work/root/usr/include" -o "$work/tiff" "$work/tiff.cpp" -L"$lib" -lOpenImageIO -lOpenImageIO_Util >"$work/log" 2>&1 || {
    tail -5 "$work/log" >&2
    echo "not tried: the libraries that OpenImageIO stands on are not there" >&2
    exit 77
}
run() { LD_LIBRARY_PATH=$lib "$work/tiff" "$@" 2>/dev/null || true; }

same "by name: written, read again" "$(run "$work/a.tif" name sRGB)" "1 1 64 48"
same "through a proxy, no colour space: written, read again" "$(run "$work/b.tif" proxy -)" "1 1 64 48"
same "through a proxy, sRGB: written, read again" "$(run "$work/c.tif" proxy sRGB)" "1 0 0 0"
same "PNG through a proxy, sRGB: written, read again" "$(run "$work/d.png" proxy sRGB)" "1 1 64 48"
holds
