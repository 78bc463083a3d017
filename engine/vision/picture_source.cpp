#include "engine/vision/picture_source.h"

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include <algorithm>
#include <cctype>
#include <system_error>
#include <vector>

namespace carina
{
namespace
{

constexpr double kUsualRate = 30.0;
constexpr double kHighestRate = 1000.0;

bool isPictureFile(const std::filesystem::path& file)
{
    std::string kind = file.extension().string();
    std::ranges::transform(kind, kind.begin(), [](unsigned char c) { return std::tolower(c); });
    return kind == ".png" || kind == ".jpg" || kind == ".jpeg";
}

std::vector<std::filesystem::path> picturesIn(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator{folder, error})
        if (isPictureFile(entry.path()))
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

GreyPicture greyOf(const cv::Mat& picture)
{
    cv::Mat grey;
    if (picture.channels() == 1)
        picture.convertTo(grey, CV_8U);
    else
        cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
    GreyPicture copied{grey.cols, grey.rows, {}};
    copied.pixels.reserve(grey.total());
    for (int row = 0; row < grey.rows; ++row)
        copied.pixels.insert(copied.pixels.end(), grey.ptr(row), grey.ptr(row) + grey.cols);
    return copied;
}

} // namespace

PicturePlace::Kind kindOfPlace(const std::filesystem::path& path)
{
    std::error_code error;
    if (std::filesystem::is_directory(path, error))
        return PicturePlace::Kind::Folder;
    const bool isFile = std::filesystem::is_regular_file(path, error); // as below /dev/shm
    return path.native().starts_with("/dev/") && !isFile ? PicturePlace::Kind::Camera
                                                         : PicturePlace::Kind::Video;
}

struct PictureSource::Reader {
    cv::VideoCapture capture;                 ///< of a camera or video
    std::vector<std::filesystem::path> files; ///< of a folder
    double rate = kUsualRate;
    bool isCamera = false;
    std::int64_t taken = 0; ///< pictures so far, those passed over included
    std::optional<double> firstStamp_ms{};

    /// The driver's stamp of a camera's picture.
    [[nodiscard]] std::optional<double> stamp_ms() const
    {
        const double ms = isCamera ? capture.get(cv::CAP_PROP_POS_MSEC) : 0.0;
        return ms > 0.0 ? std::optional{ms} : std::nullopt;
    }

    std::optional<cv::Mat> picture()
    {
        cv::Mat read;
        while (std::size_t(taken) < files.size() && read.empty())
            read = cv::imread(files[std::size_t(taken++)].string(), cv::IMREAD_GRAYSCALE);
        if (files.empty() && capture.read(read))
            ++taken;
        return read.empty() ? std::nullopt : std::optional{read};
    }

    Result<void> openCapture(const PicturePlace& place)
    {
        const std::string name = place.path.string();
        if (!isCamera) {
            if (!capture.open(name, cv::CAP_FFMPEG) && !capture.open(name, cv::CAP_OPENCV_MJPEG))
                return fail(Errc::UnknownFormat, name + ": no video that can be read");
            rate = capture.get(cv::CAP_PROP_FPS);
        } else {
            if (!capture.open(name, cv::CAP_V4L2))
                return fail(Errc::TrackerFailed, name + ": no camera answers there");
            if (place.width > 0 && place.height > 0) {
                capture.set(cv::CAP_PROP_FOURCC, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'));
                capture.set(cv::CAP_PROP_FRAME_WIDTH, place.width);
                capture.set(cv::CAP_PROP_FRAME_HEIGHT, place.height);
            }
            capture.set(cv::CAP_PROP_FPS, place.rate);
            capture.set(cv::CAP_PROP_BUFFERSIZE, 1);
            rate = capture.get(cv::CAP_PROP_FPS);
        }
        if (!(rate > 0.0 && rate <= kHighestRate))
            rate = kUsualRate;
        return {};
    }
};

PictureSource::PictureSource(std::unique_ptr<Reader> reader) : m_reader{std::move(reader)} {}
PictureSource::PictureSource(PictureSource&&) noexcept = default;
PictureSource& PictureSource::operator=(PictureSource&&) noexcept = default;
PictureSource::~PictureSource() = default;

Result<PictureSource> PictureSource::open(const PicturePlace& place)
{
    // What fails is told by the result; a webcam that is awaited would be complained of for ever.
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    auto reader = std::make_unique<Reader>();
    reader->isCamera = place.kind == PicturePlace::Kind::Camera;
    std::error_code error;
    if (!reader->isCamera && !std::filesystem::exists(place.path, error))
        return fail(Errc::FileNotFound, place.path.string());
    try {
        if (place.kind == PicturePlace::Kind::Folder) {
            reader->files = picturesIn(place.path);
            reader->rate = place.rate;
            if (reader->files.empty())
                return fail(Errc::NothingRecognised, place.path.string() + ": no PNG or JPEG");
        } else if (auto opened = reader->openCapture(place); !opened) {
            return tl::unexpected(opened.error());
        }
    } catch (const cv::Exception& thrown) {
        return fail(Errc::TrackerFailed, place.path.string() + ": " + thrown.err);
    }
    return PictureSource{std::move(reader)};
}

std::optional<PictureSource::Taken> PictureSource::next()
{
    try {
        const auto picture = m_reader->picture();
        if (!picture)
            return std::nullopt;
        Taken taken{.picture = greyOf(*picture)};
        taken.time = fromSeconds(double(m_reader->taken - 1) / m_reader->rate);
        if (const auto ms = m_reader->stamp_ms()) {
            taken.stamped = LocalTime{fromSeconds(1e-3 * *ms)};
            if (!m_reader->firstStamp_ms)
                m_reader->firstStamp_ms = ms;
            taken.time = fromSeconds(1e-3 * (*ms - *m_reader->firstStamp_ms));
        }
        return taken;
    } catch (const cv::Exception&) {
        return std::nullopt; // a video that is damaged from here on
    }
}

bool PictureSource::skip()
{
    try {
        const bool isThere = m_reader->files.empty()
                                 ? m_reader->capture.grab()
                                 : std::size_t(m_reader->taken) < m_reader->files.size();
        if (isThere)
            ++m_reader->taken;
        return isThere;
    } catch (const cv::Exception&) {
        return false;
    }
}

double PictureSource::rate() const { return m_reader->rate; }

} // namespace carina
