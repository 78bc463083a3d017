#pragma once

#include "models/station/shared_tools.h"
#include "ui/tracker/program_tracker_panel.h"

#include <QPointer>
#include <QWidget>

#include <chrono>

namespace carina::program
{

/// The tracker and the site of a program, which a person may choose while it runs, and which change
/// where the wizard writes the site anew.
class TrackerChange
{
public:
    static constexpr std::chrono::hours kLook{1};

    /// What a program begins with.
    struct Beginning {
        QString site{}; ///< its file; empty: none
        std::optional<TrackerChoice> tracker{};
        /// Whether the tracker is made of the devices that the site names, whichever those are.
        bool isOfSite = false;
        std::string conversation{}; ///< of a tracker that is chosen (TrackerChoice)
    };

    explicit TrackerChange(const Beginning& beginning);

    /// The site as of now, for a patient.
    [[nodiscard]] Result<SharedTools::Place> placeOf(const PatientModel& patient) const;

    /// Asks for a tracker, and for the file of a site where the program did not begin with one and
    /// the tracker needs one, and tracks with it. What goes wrong is shown; the tracker before is
    /// used on then.
    void ask(QWidget& window, SharedTools& tools);
    /// Tracks with a tracker that a person chose, at the site that they chose with it: another
    /// tracker has another one, or none. The site that the program began with holds for all.
    void use(QWidget& window, SharedTools& tools, TrackerChoice tracker, const QString& site = {});
    /// Goes on without a tracker.
    void take(QWidget& window, SharedTools& tools);

    /// Takes over the site as it is now, and whenever it is written anew until `context` is
    /// destroyed; also one that is chosen later. Devices of the site that were changed are
    /// replaced, those that were calibrated anew are put in their new places, and the others go on.
    /// How far its registration can be relied on is judged again at each kLook: it becomes too old
    /// without anything being written.
    /// @pre both outlive `context`; not called before its end.
    void watch(QObject& context, SharedTools& tools);

private:
    void watchNow();
    void takeSite(SharedTools& tools);
    [[nodiscard]] bool takeDevices(SharedTools& tools);
    /// @returns whether it tracks with it now; else the window said why not.
    bool give(QWidget& window, SharedTools& tools, std::optional<TrackerChoice> tracker);

    QString m_siteOfStart; ///< empty: each tracker is chosen with its own
    QString m_site;
    QString m_identity; ///< of the tracker
    bool m_isOfSite;
    std::string m_conversation;
    QPointer<QObject> m_context; ///< of watch()
    std::function<void()> m_written;
};

/// What a window shows of the tracker of these tools, and offers to change of it.
/// @param folder where the program remembers what a person chose of it
/// @pre tools, recording and offer outlive the window.
[[nodiscard]] ProgramTracker programTracker(SharedTools& tools, PoseRecording& recording,
                                            OfferSwitch& offer, bool canBeGiven,
                                            const QString& folder);

} // namespace carina::program
