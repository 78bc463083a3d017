#pragma once

#include "engine/core/result.h"
#include "engine/vision/board_calibration.h"
#include "engine/vision/picture_source.h"
#include "models/tracker/tracker_choice.h"

#include <QObject>
#include <QSize>

#include <memory>
#include <mutex>
#include <thread>

namespace carina
{

/// A camera whose calibration is to be made.
struct CameraToCalibrate {
    QString place{}; ///< "/dev/video0", a video, or a folder of pictures
    QString file{};  ///< where its calibration is written; never one of OpenCV, which is kept
    QSize size{};    ///< of its pictures, as the present calibration says
};

/// The camera of a tracker; nothing where it has none.
[[nodiscard]] std::optional<CameraToCalibrate> cameraOf(const TrackerChoice& choice);

/// Calibrates a camera while somebody shows it the printed board: looks at its pictures on a thread
/// of its own, keeps those that show the board at a new place, and tells how far it is.
class CameraCalibration : public QObject
{
    Q_OBJECT

public:
    CameraCalibration();
    ~CameraCalibration() override;

    /// Begins anew. @param square_mm side of a square of the board, as measured on the print
    void begin(const CameraToCalibrate& camera, double square_mm);
    /// Frees the camera, as soon as its driver lets go; what was found is kept.
    void end();

    /// Corners seen in each ninth of the picture, row by row.
    [[nodiscard]] BoardCoverage coverage() const;
    /// Whether these pictures determine the camera.
    [[nodiscard]] bool isFitted() const;
    /// How far it is, and what to do next. Empty while idle.
    [[nodiscard]] QString text() const;

    /// Writes the calibration. @pre isFitted() @returns FileUnwritable
    [[nodiscard]] Result<void> save(const QString& file) const;

Q_SIGNALS:
    void changed();

private:
    enum class State : std::uint8_t {
        Idle,
        Looking,
        Ended,  ///< of a video or folder, its end is reached
        Silent, ///< there is no picture
    };

    using Fitted = std::variant<BoardFit, CalibrationFault>;
    struct Progress {
        State state = State::Idle;
        BoardCoverage coverage{};
        std::optional<Fitted> fitted{};
        std::string trouble{};
    };

    /// What is shared with the thread, which may still wait for a picture when this has ended.
    struct Shared {
        std::mutex mutex;
        Progress progress;
        CameraCalibration* owner = nullptr; ///< null once that has ended
    };

    static void look(const std::stop_token& stopping, Shared& shared, const PicturePlace& place,
                     const CalibrationBoard& board);
    static void tell(Shared& shared, Progress progress, const std::stop_token& stopping);
    [[nodiscard]] Progress progress() const;
    [[nodiscard]] static QString faultText(CalibrationFault fault);

    std::shared_ptr<Shared> m_shared;
    std::jthread m_thread;
};

} // namespace carina
