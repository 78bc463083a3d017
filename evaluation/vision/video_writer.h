#pragma once

#include "engine/core/result.h"
#include "engine/vision/grey_picture.h"

#include <filesystem>
#include <memory>

namespace carina
{

/// Writes pictures of one size as a video, Motion JPEG in an AVI file.
class VideoWriter
{
public:
    /// @returns FileUnwritable
    [[nodiscard]] static Result<VideoWriter> open(const std::filesystem::path& file, double rate,
                                                  int width, int height);

    VideoWriter(VideoWriter&&) noexcept;
    VideoWriter& operator=(VideoWriter&&) noexcept;
    ~VideoWriter(); ///< The file is whole only then.

    /// @returns FileUnwritable for a picture of another size, and where the disk is full.
    [[nodiscard]] Result<void> add(const GreyPicture& picture);

private:
    struct Encoder;
    explicit VideoWriter(std::unique_ptr<Encoder> encoder);

    std::unique_ptr<Encoder> m_encoder;
};

/// Writes a picture as PNG. @returns FileUnwritable
[[nodiscard]] Result<void> writePicture(const std::filesystem::path& file,
                                        const GreyPicture& picture);

} // namespace carina
