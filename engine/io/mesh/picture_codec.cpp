#include "engine/io/mesh/picture_codec.h"

#include <png.h>
#include <turbojpeg.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>

namespace carina
{
namespace
{

constexpr std::size_t kMostPixels = std::size_t{1} << 26;
constexpr std::string_view kStartOfPng{"\x89PNG\r\n\x1a\n", 8};
constexpr std::string_view kStartOfJpeg{"\xff\xd8\xff", 3};

static_assert(sizeof(Rgb) == 3, "decoders write pixels as they lie in memory");

Result<Picture> blankPicture(std::size_t width, std::size_t height)
{
    if (width == 0 || height == 0 || width > kMostPixels / height)
        return fail(Errc::FileMalformed, "a picture of a size that cannot be");
    return Picture{width, height, {}};
}

Result<Picture> decodePng(std::string_view bytes)
{
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    const std::unique_ptr<png_image, decltype(&png_image_free)> owner{&image, &png_image_free};
    if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0)
        return fail(Errc::FileMalformed, image.message);
    auto picture = blankPicture(image.width, image.height);
    if (!picture)
        return picture;
    image.format = PNG_FORMAT_RGBA;
    std::vector<std::array<std::uint8_t, 4>> pixels(picture->width * picture->height);
    if (png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) == 0)
        return fail(Errc::FileMalformed, image.message);
    for (const auto& [red, green, blue, alpha] : pixels)
        picture->pixels.push_back({red, green, blue});
    return picture;
}

Result<Picture> decodeJpeg(std::string_view bytes)
{
    const std::unique_ptr<void, decltype(&tjDestroy)> decoder{tjInitDecompress(), &tjDestroy};
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    int width = 0;
    int height = 0;
    int subsampling = 0;
    int colorSpace = 0;
    if (!decoder
        || tjDecompressHeader3(decoder.get(), data, bytes.size(), &width, &height, &subsampling,
                               &colorSpace)
               != 0)
        return fail(Errc::FileMalformed, tjGetErrorStr2(decoder.get()));
    auto picture = blankPicture(std::size_t(width), std::size_t(height));
    if (!picture)
        return picture;
    picture->pixels.resize(picture->width * picture->height);
    if (tjDecompress2(decoder.get(), data, bytes.size(), picture->pixels.front().data(), width, 0,
                      height, TJPF_RGB, 0)
        != 0)
        return fail(Errc::FileMalformed, tjGetErrorStr2(decoder.get()));
    return picture;
}

} // namespace

Result<Picture> decodePicture(std::string_view bytes)
{
    if (bytes.starts_with(kStartOfPng))
        return decodePng(bytes);
    if (bytes.starts_with(kStartOfJpeg))
        return decodeJpeg(bytes);
    return fail(Errc::UnknownFormat, "a picture that is neither PNG nor JPEG");
}

} // namespace carina
