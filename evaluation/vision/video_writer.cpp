#include "evaluation/vision/video_writer.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

namespace carina
{
namespace
{

constexpr double kQuality = 95.0;

/// A view, without a copy; OpenCV does not write into it.
cv::Mat viewOf(const GreyPicture& picture)
{
    return {picture.height, picture.width, CV_8UC1,
            const_cast<std::uint8_t*>(picture.pixels.data())};
}

} // namespace

struct VideoWriter::Encoder {
    cv::VideoWriter writer;
    std::string file;
    int width = 0;
    int height = 0;
};

VideoWriter::VideoWriter(std::unique_ptr<Encoder> encoder) : m_encoder{std::move(encoder)} {}
VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;
VideoWriter& VideoWriter::operator=(VideoWriter&&) noexcept = default;
VideoWriter::~VideoWriter() = default;

Result<VideoWriter> VideoWriter::open(const std::filesystem::path& file, double rate, int width,
                                      int height)
{
    auto encoder = std::make_unique<Encoder>();
    encoder->file = file.string();
    encoder->width = width;
    encoder->height = height;
    try {
        if (!encoder->writer.open(encoder->file, cv::CAP_OPENCV_MJPEG,
                                  cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), rate,
                                  {width, height}, true))
            return fail(Errc::FileUnwritable, encoder->file);
        encoder->writer.set(cv::VIDEOWRITER_PROP_QUALITY, kQuality);
    } catch (const cv::Exception& thrown) {
        return fail(Errc::FileUnwritable, encoder->file + ": " + thrown.err);
    }
    return VideoWriter{std::move(encoder)};
}

Result<void> VideoWriter::add(const GreyPicture& picture)
{
    if (picture.width != m_encoder->width || picture.height != m_encoder->height)
        return fail(Errc::FileUnwritable, m_encoder->file + ": a picture of another size");
    try {
        cv::Mat coloured; // the encoder damages grey pictures
        cv::cvtColor(viewOf(picture), coloured, cv::COLOR_GRAY2BGR);
        m_encoder->writer.write(coloured);
    } catch (const cv::Exception& thrown) {
        return fail(Errc::FileUnwritable, m_encoder->file + ": " + thrown.err);
    }
    return {};
}

Result<void> writePicture(const std::filesystem::path& file, const GreyPicture& picture)
{
    try {
        if (cv::imwrite(file.string(), viewOf(picture)))
            return {};
    } catch (const cv::Exception&) { // said below
    }
    return fail(Errc::FileUnwritable, file.string());
}

} // namespace carina
