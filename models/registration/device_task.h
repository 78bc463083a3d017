#pragma once

#include "engine/tracking/delivery_thread.h"
#include "models/site/site_editor.h"
#include "models/tracker/device_calibration.h"
#include "models/tracker/tracker_form.h"

#include <QString>

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace carina
{

/// Names the devices that track at a site, and how each stands to the first.
class DeviceTask
{
public:
    /// What a program lends to it.
    struct Access {
        const Tracker* tracker = nullptr; ///< with which it tracks
        QString trackerName{};
        ReadSessionClock clock{};
        /// The devices of the site that this tracker was made of; nothing for another tracker.
        std::optional<std::vector<SiteDevice>> tracked{};
        MakeDevice make{}; ///< describedTracker on the clock, unless given
        /// Called with false before devices are used by a calibration: this tracker gives them
        /// free; and with true when that has ended.
        std::function<Result<void>(bool tracks)> track{};
    };

    /// A device as it is shown.
    struct Row {
        QString name{};       ///< its kind and address
        QString state{};      ///< how it tracks now
        QString calibrated{}; ///< how its frame was found, when, and how well both agreed
    };

    /// @param file of the site
    /// @pre the editor outlives this.
    DeviceTask(SiteEditor& editor, std::filesystem::path file, Access access);

    [[nodiscard]] std::size_t count() const { return devices().size(); }
    [[nodiscard]] std::vector<Row> rows() const;
    /// As the site file names it.
    [[nodiscard]] const std::string& fileOf(std::size_t device) const
    {
        return devices().at(device).file;
    }

    /// Whether the tracker is made of the devices that the site has now.
    [[nodiscard]] bool isTracked() const;
    /// Whether it was made of the site's devices, which were changed since.
    [[nodiscard]] bool isOutdated() const { return m_access.tracked && !isTracked(); }

    /// One sentence: why a device can be neither removed nor replaced; empty if it can.
    [[nodiscard]] QString whyKept(std::size_t device) const;

    /// The fields that the window which asks for a device begins with.
    [[nodiscard]] TrackerForm offeredForm() const;
    /// A device that a person chose, as the site file will name it. Its description is written
    /// beside the site, unless it lies there or below. Refused for the simulated tracker, a
    /// recording, a camera that is described elsewhere, and a device that the site has already.
    [[nodiscard]] std::optional<std::string> kept(const TrackerForm& form,
                                                  const TrackerChoice& choice);

    /// A device to be calibrated to the first: one of the site or another one.
    struct Wanted {
        std::string file;
        std::optional<std::size_t> replaced{}; ///< of the site: the one that it comes in place of
    };

    /// Whether this device becomes the first one, which needs no calibration.
    [[nodiscard]] bool isFirst(const Wanted& wanted) const;
    void setFirst(const Wanted& wanted);

    /// What is needed for that; refused where the devices cannot be used together.
    [[nodiscard]] std::optional<DevicesToCalibrate> toCalibrate(const Wanted& wanted);
    [[nodiscard]] const MakeDevice& make() const { return m_access.make; }
    /// The tracker gives its devices free. @returns false where it does not, which is said.
    [[nodiscard]] bool lend();
    void takeBack();
    void store(const Wanted& wanted, const FrameCalibration& found);

    void remove(std::size_t device);

    /// The site may have changed.
    void follow();

private:
    [[nodiscard]] const std::vector<SiteDevice>& devices() const { return m_editor.site().devices; }
    [[nodiscard]] Row rowOf(std::size_t device) const;
    [[nodiscard]] QString stateOf(const TrackerDescription& described) const;
    [[nodiscard]] Result<Site> withoutReplaced(const Wanted& wanted) const;
    void adopt(Result<Site> site);

    SiteEditor& m_editor;
    std::filesystem::path m_file;
    std::filesystem::path m_folder;
    Access m_access;
    std::vector<std::string> m_files; ///< of the devices as they were read
    std::vector<Result<TrackerDescription>> m_described;
};

} // namespace carina
