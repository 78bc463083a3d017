// Any bytes as the texture of an anatomy set: refused with a reason, or read as a picture that has
// all its pixels, without a fault that a sanitizer sees.

#include "engine/core/expects.h"
#include "engine/io/mesh/picture_codec.h"

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto picture = carina::decodePicture({reinterpret_cast<const char*>(data), size});
    if (picture)
        CARINA_EXPECTS(picture->width > 0
                       && picture->pixels.size() == picture->width * picture->height);
    else
        CARINA_EXPECTS(!picture.error().detail.empty());
    return 0;
}
