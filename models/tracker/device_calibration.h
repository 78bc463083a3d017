#pragma once

#include "engine/tracking/several/body_watch.h"
#include "engine/tracking/several/frame_calibration.h"
#include "models/tracker/tracker_choice.h"

#include <QObject>
#include <QStringList>
#include <QTimer>

#include <array>
#include <functional>
#include <optional>

namespace carina
{

/// The tracker that a description is of, not started. All that are made stamp by one clock.
using MakeDevice = std::function<Result<std::unique_ptr<Tracker>>(const TrackerDescription&)>;

/// Two devices of a site, of which the second is to be calibrated to the first.
struct DevicesToCalibrate {
    TrackerDescription first;
    TrackerDescription second;
};

/// Finds how a device stands to the first one of a site, while a person turns a body about that
/// both see: collects what they see for half a minute, tells how far it was turned and moved and
/// what is missing, and then whether the frame that was found can be used.
class DeviceCalibration : public QObject
{
    Q_OBJECT

public:
    static constexpr int kInterval_ms = 200;
    /// For so long both have to see the body.
    static constexpr Duration kWatched = std::chrono::seconds{30};

    enum class State : std::uint8_t {
        Idle,
        Watching,
        Accepted, ///< the frame can be used
        Refused,
    };

    DeviceCalibration(DevicesToCalibrate devices, MakeDevice make, QObject* parent = nullptr);

    /// The tools of a device that can be on the body, as shown.
    [[nodiscard]] QStringList toolsOfFirst() const { return toolsOf(m_devices.first); }
    [[nodiscard]] QStringList toolsOfSecond() const { return toolsOf(m_devices.second); }

    /// Begins anew with a tool of each, by their places in these lists. Both devices are used until
    /// it ends, and must not be in use meanwhile.
    void begin(int toolOfFirst, int toolOfSecond);
    /// Gives both devices free; what was seen is dropped.
    void cancel();
    /// Takes what came since the last time; a timer calls it.
    void look();

    [[nodiscard]] State state() const { return m_state; }
    /// Of the time for which both have to see the body, 0 to 1.
    [[nodiscard]] double share() const;

    /// How far the body was turned about an axis of its motion, or moved.
    struct Coverage {
        QString name;
        QString amount;     ///< with its unit
        double share = 0.0; ///< of what is needed, 0 to 1
        bool isEnough = false;
    };
    /// About the three axes of the motion, the one that it was turned about most first; and how far
    /// it was moved.
    [[nodiscard]] std::array<Coverage, 4> coverage() const;

    /// A sentence: what to do now, or what was found and whether it was accepted. Empty while idle.
    [[nodiscard]] QString text() const { return m_text; }

    /// @pre it was accepted.
    [[nodiscard]] const FrameCalibration& found() const;

Q_SIGNALS:
    void changed();

private:
    [[nodiscard]] static QStringList toolsOf(const TrackerDescription& described);
    [[nodiscard]] Result<BodyWatch> watched(int toolOfFirst, int toolOfSecond) const;
    [[nodiscard]] QString whatToDo() const;
    [[nodiscard]] static QString whyUnseen(const TrackerDescription& described,
                                           const BodyWatch::Sight& sight);
    void finish();
    void refuse(const QString& sentence);

    DevicesToCalibrate m_devices;
    MakeDevice m_make;
    std::optional<BodyWatch> m_watch;
    BodyMotion m_motion; ///< as the first device saw it
    Duration m_together{};
    std::optional<FrameCalibration> m_found;
    State m_state = State::Idle;
    QString m_text;
    QTimer m_timer;
};

} // namespace carina
