#pragma once

#include "apps/trainee/trainee_station.h"
#include "ui/trainee/trainee_window.h"

namespace carina
{

/// The tracker and the site of a trainee's program, which a person may choose while it runs.
class TrackerChange
{
public:
    /// @param site file of the site; empty: none
    /// @param conversation of a tracker that is chosen (TrackerChoice)
    TrackerChange(QString site, const std::optional<TrackerChoice>& tracker,
                  std::string conversation);

    /// The site as of now, for a patient.
    [[nodiscard]] Result<TraineeStation::Place> placeOf(const PatientModel& patient) const;

    /// Asks for a tracker, and for the file of a site where there is none and the tracker needs
    /// one, and gives it to the station. What goes wrong is shown; the tracker before is used on
    /// then.
    /// @param show as in TraineeStation::lay
    void ask(TraineeWindow& window, TraineeStation& station, const std::function<void()>& show);
    /// Goes on without a tracker.
    void take(TraineeWindow& window, TraineeStation& station, const std::function<void()>& show);

    /// Takes over the site when it is written anew; call it once, and it holds for a site that is
    /// chosen later.
    void watch(TraineeWindow& window, TraineeStation& station, std::function<void()> show);

private:
    void watchNow(TraineeWindow& window);
    /// @returns whether it tracks with it now; else the window said why not.
    bool give(TraineeWindow& window, TraineeStation& station, std::optional<TrackerChoice> tracker,
              const std::function<void()>& show);

    QString m_site;
    QString m_identity; ///< of the tracker
    std::string m_conversation;
    std::function<void()> m_written;
};

} // namespace carina
