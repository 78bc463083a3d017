#pragma once

#include "engine/core/result.h"
#include "engine/core/session_time.h"
#include "engine/vision/grey_picture.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace carina
{

/// Where pictures come from.
struct PicturePlace {
    enum class Kind : std::uint8_t { Camera, Video, Folder };

    Kind kind = Kind::Camera;
    std::filesystem::path path{}; ///< "/dev/video0", a video, or a folder of PNG and JPEG files
    double rate = 30.0;           ///< pictures a second: of a folder; asked of a camera
    int width = 0;                ///< asked of a camera, pixels; 0: as it likes
    int height = 0;
};

/// What a path is: a folder, a video, or below /dev what is no file, a camera.
[[nodiscard]] PicturePlace::Kind kindOfPlace(const std::filesystem::path& path);

/// Pictures one after another, from a webcam, a video or the files of a folder in the order of
/// their names.
class PictureSource
{
public:
    struct Taken {
        GreyPicture picture;
        /// Since the first picture, by the rate of the video or folder, or by the camera's own
        /// stamps.
        Duration time{};
        /// When the exposure of a camera's picture had ended, on CLOCK_MONOTONIC by the driver's
        /// stamp; nothing where it gives none, and for files.
        std::optional<LocalTime> stamped{};
    };

    /// @returns TrackerFailed where there is no such device, or it gives no picture; FileNotFound;
    ///          UnknownFormat for a file that is no video; NothingRecognised for a folder without
    ///          pictures. The detail begins with the path.
    [[nodiscard]] static Result<PictureSource> open(const PicturePlace& place);

    PictureSource(PictureSource&&) noexcept;
    PictureSource& operator=(PictureSource&&) noexcept;
    ~PictureSource();

    /// The next picture. Waits for that of a camera. std::nullopt at the end, and where a camera
    /// was unplugged; the file of a picture that cannot be read is passed over.
    [[nodiscard]] std::optional<Taken> next();
    /// Passes over the next picture without decoding it. @returns false at the end.
    bool skip();
    /// Pictures a second.
    [[nodiscard]] double rate() const;

private:
    struct Reader;
    explicit PictureSource(std::unique_ptr<Reader> reader);

    std::unique_ptr<Reader> m_reader;
};

} // namespace carina
