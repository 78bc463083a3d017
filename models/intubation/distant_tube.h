#pragma once

#include "models/intubation/sent_shape.h"
#include "models/intubation/tube_in_airway.h"
#include "models/patient/patient_lumen.h"

#include <optional>
#include <vector>

namespace carina
{

/// The tube of another who is at work, as its owner has it.
///
/// Eight numbers do not tell each bend of a rod in an airway. But here are the same patient, the
/// poses of the connector as they arrive, and the tube at rest: the patient's own, or as the form
/// that is sent tells it. So the same rod is stepped in the same lumen (ElasticTube), and only the
/// difference of the form that was sent last from its own at the same moment is taken from there,
/// by the same numbers: none where poses and tissue were the same. Where both tubes lie
/// differently, as where one is held up at the cords and the other is not, by more than kTooFar,
/// the rod here is drawn as it lies, since eight numbers alone can be almost a centimetre off a rod
/// that walls bend; and after kLaidAnew it is laid anew, as it was at first, with its tip where the
/// form has it, and so in the same way and as far in. While there is no lumen the form that was
/// sent is drawn as it is; so it is of what is no tube that is sold, or is another one within
/// kSameTube: a lumen takes seconds to measure, and who sends decides what is sent.
class DistantTube
{
public:
    /// Another patient lies there from now on. @pre it outlives this, or lives until the next one
    void lieIn(const PatientModel& patient);

    /// How it is drawn at a moment; as its pose has it where its owner has not told a form for
    /// kKeptWithout.
    /// @param tissue as it is drawn then
    [[nodiscard]] TubeInAirway at(const StationMoment& moment, const TissueAround& tissue);

    /// In which its rod lies, for tubes as thick as that of the latest form.
    [[nodiscard]] const PatientLumen& lumen() const { return m_lumen; }

    static constexpr Length kTooFar = millimetres(2.0);                   ///< of ours
    static constexpr Duration kLaidAnew = std::chrono::milliseconds{500}; ///< of ours
    /// Its owner may have no time to send a form, and the poses go on: of ours.
    static constexpr Duration kKeptWithout = std::chrono::seconds{2};
    static constexpr Duration kSameTube = std::chrono::seconds{5}; ///< of ours

private:
    [[nodiscard]] bool isOf(const StreamShape& shape, SessionTime now);
    [[nodiscard]] bool isKept(SessionTime now) const;
    [[nodiscard]] std::vector<Vec3> drawn(const StationMoment& moment,
                                          const TissueAround& tissue) const;
    void follow(const RemoteObject& poses, SessionTime now, SessionTime sent,
                const TissueAround& tissue);
    void compare(const StreamShape& sent, const RemoteObject& poses, const TissueAround& tissue);
    [[nodiscard]] bool layAs(const StreamShape& sent, const RemoteObject& poses,
                             const TissueAround& tissue);

    const PatientModel* m_patient = nullptr;
    std::optional<StreamShape> m_of; ///< whose tube at rest it is
    SessionTime m_since{};           ///< since when
    PatientLumen m_lumen;
    std::optional<ElasticTube> m_tube;     ///< once its lumen is there
    std::optional<SessionTime> m_compared; ///< the time of the latest form it was compared with
    /// Of that form from the one that the rod had then, at the nodes; nothing where they are too
    /// far apart.
    std::optional<std::vector<Vec3>> m_off;
    std::optional<SessionTime> m_formAt; ///< when a form was known last
    std::optional<SessionTime> m_agreed; ///< when both lay alike last
};

} // namespace carina
