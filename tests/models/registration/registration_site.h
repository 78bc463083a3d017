#pragma once

#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/geometry/rotation.h"
#include "engine/io/anatomy_set/builtin_cache.h"
#include "engine/tracking/tracker.h"
#include "models/registration/registration_model.h"

#include <QTemporaryDir>

#include <cmath>
#include <memory>
#include <random>

namespace carina
{

/// A tracker of a stylus and a chin probe, and of a tube and a laryngoscope if it is asked for
/// them, whose samples a test writes by hand.
class WrittenTracker : public Tracker
{
public:
    [[nodiscard]] Result<void> start() override { return {}; }
    void stop() override {}
    [[nodiscard]] std::vector<TrackedTool> tools() const override
    {
        std::vector<TrackedTool> tools{{"Stylus", ToolRole::Stylus, &m_stylus},
                                       {"Chin", ToolRole::Jaw, &m_chin}};
        if (!m_hasStylus)
            tools.erase(tools.begin());
        if (m_hasTools) {
            tools.push_back({"ETT", ToolRole::Tube, &m_tube});
            tools.push_back({"Scope", ToolRole::Laryngoscope, &m_laryngoscope});
        }
        return tools;
    }

    mutable PoseHistory m_stylus;
    mutable PoseHistory m_chin;
    mutable PoseHistory m_tube;
    mutable PoseHistory m_laryngoscope;
    bool m_hasTools = false;
    bool m_hasStylus = true;
};

/// A technician's desk without hardware and without time: the manikin truly lies at X_TA and the
/// stylus truly ends at p_SQ. Every sample and every touch is exact, unless noise is asked for.
class RegistrationSite
{
public:
    static constexpr Duration kPeriod = std::chrono::microseconds{16'667};
    static constexpr Length kHeight = metres(1.5);

    explicit RegistrationSite(bool hasTools = false) { m_tracker.m_hasTools = hasTools; }
    /// For the models that are made from now on.
    void removeStylus() { m_tracker.m_hasStylus = false; }

    [[nodiscard]] std::filesystem::path file() const
    {
        return m_folder.filePath(QStringLiteral("site.json")).toStdString();
    }
    [[nodiscard]] std::filesystem::path beside(const char* name) const
    {
        return m_folder.filePath(QLatin1String{name}).toStdString();
    }
    [[nodiscard]] static const PatientModel& patient()
    {
        static const PatientModel child = *PatientModel::of(*madeChild(), millimetres(6));
        return child;
    }
    /// Eight, six and four landmarks.
    [[nodiscard]] static std::vector<LandmarkCatalogue> sets()
    {
        const LandmarkCatalogue four = ribCageCatalogue(kHeight, patient().contentHash());
        const LandmarkCatalogue eight = ribCageAndJawCatalogue(four, furtherPlaces(kHeight));
        LandmarkCatalogue six = eight;
        six.landmarks.resize(6);
        return {eight, six, four};
    }
    [[nodiscard]] static std::vector<Landmark> landmarks() { return sets().front().landmarks; }
    [[nodiscard]] static std::vector<Landmark> checks()
    {
        return {{"Inner end of the left clavicle", {0.02, -0.05, 0.04}},
                {"Inner end of the right clavicle", {-0.02, -0.05, 0.04}}};
    }

    /// A model on what the file holds now, as a program makes one when it starts.
    [[nodiscard]] std::unique_ptr<RegistrationModel> model()
    {
        return std::make_unique<RegistrationModel>(
            RegistrationModel::Workplace{.file = file(),
                                         .tracker = &m_tracker,
                                         .trackerName = m_trackerName,
                                         .clock = [this] { return std::optional{m_now}; },
                                         .landmarks = sets(),
                                         .checks = checks(),
                                         .today = [this] { return m_today; },
                                         .trackedDevices = m_trackedDevices,
                                         .past = m_past},
            RegistrationModel::siteOf(file(), patient()).value(), patient());
    }

    /// The next sample of the stylus, its tip at a point.
    void tipAt(const Vec3& p_TQ, const Quat& q_TS = Quat::Identity())
    {
        m_now += kPeriod;
        const Vec3 p_TS = p_TQ - q_TS * p_SQ + stray(m_noise);
        m_tracker.m_stylus.push(
            {.time = m_now, .X_FO = {q_TS, p_TS}, .covariance_O = m_covariance_S});
        m_tracker.m_chin.push({.time = m_now, .X_FO = X_TJ});
        if (!m_tracker.m_hasTools)
            return;
        const auto validity = m_areToolsSeen ? Validity::Tracked : Validity::Lost;
        m_tracker.m_tube.push({.time = m_now, .X_FO = m_X_TN_tube, .validity = validity});
        m_tracker.m_laryngoscope.push(
            {.time = m_now, .X_FO = m_X_TN_laryngoscope, .validity = validity});
    }

    /// So many samples of the stylus as it is swung about a divot, from wherever that stands.
    void swingFor(RegistrationModel& model, int samples)
    {
        for (int i = 0; i < samples && model.stylus().isLookingForTip(); ++i, ++m_swung) {
            tipAt({0.1, 0.0, -1.0}, rotationFromVector({0.4 * std::cos(0.1 * m_swung),
                                                        0.4 * std::sin(0.1 * m_swung), 0.0}));
            model.look();
        }
    }
    /// Until the model has seen enough.
    void swing(RegistrationModel& model) { swingFor(model, 900); }

    /// Holds the tip still, for a little longer than it takes.
    void hold(RegistrationModel& model, const Vec3& p_TQ, const Quat& q_TS = Quat::Identity())
    {
        holdFor(model, 70, p_TQ, q_TS);
    }
    void holdFor(RegistrationModel& model, int samples, const Vec3& p_TQ,
                 const Quat& q_TS = Quat::Identity())
    {
        const Vec3 p_TQ_held = p_TQ + stray(m_hand);
        for (int i = 0; i < samples; ++i) {
            tipAt(p_TQ_held, q_TS);
            model.look();
        }
    }

    /// Tracker, tip, landmarks.
    void prepare(RegistrationModel& model)
    {
        model.useTracker();
        swing(model);
        model.landmarkTask().accept();
    }
    void touchFirst(RegistrationModel& model, std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i)
            hold(model, X_TA * landmarks()[i].p_AQ);
    }
    /// Everything up to the touched landmarks.
    void touchAll(RegistrationModel& model)
    {
        prepare(model);
        touchFirst(model, landmarks().size());
    }
    void fitAll(RegistrationModel& model)
    {
        touchAll(model);
        model.fitting().fit();
    }
    /// Touches all places to check, at where they truly are.
    void verifyAll(RegistrationModel& model)
    {
        model.enter(SiteStep::Verify);
        for (std::size_t i = 0; i < checks().size() + 1; ++i)
            hold(model, X_TA * model.verifying().points().at(i).p_AQ);
    }

    /// Any direction, of that RMS length.
    [[nodiscard]] Vec3 stray(Length rms)
    {
        if (rms.si == 0.0)
            return Vec3::Zero();
        std::normal_distribution<double> part{0.0, rms.si / std::sqrt(3.0)};
        return {part(m_random), part(m_random), part(m_random)};
    }

    const RigidTransform X_TA{rotationFromVector({0.2, 1.0, -0.4}), {0.05, -0.1, -1.1}};
    const RigidTransform X_TJ{rotationFromVector({0.1, 0.0, 0.3}), {0.0, 0.1, -1.2}};
    const Vec3 p_SQ{0.002, -0.001, -0.12};
    RigidTransform m_X_TN_tube{rotationFromVector({0.3, -0.2, 0.5}), {0.2, 0.1, -1.2}};
    RigidTransform m_X_TN_laryngoscope = RigidTransform::translation({-0.2, 0.1, -1.2});
    bool m_areToolsSeen = true;
    std::optional<Mat6> m_covariance_S{}; ///< that the tracker tells of the stylus' pose
    Length m_noise{};                     ///< of each sample's position, RMS
    Length m_hand{};                      ///< of each touch from its place, RMS
    std::mt19937 m_random{2004};
    WrittenTracker m_tracker;
    QString m_trackerName = QStringLiteral("Written tracker");
    SessionTime m_now{std::chrono::seconds{100}};
    QDateTime m_today{{2004, 3, 27}, {10, 15}, Qt::UTC};
    std::optional<std::vector<SiteDevice>> m_trackedDevices{};
    std::vector<Site> m_past{}; ///< of a model before

private:
    /// Making the patient takes seconds: where a run of tests has a cache of its own, the first
    /// test leaves the patient there.
    static Result<Anatomy> madeChild()
    {
        return qEnvironmentVariableIsSet("XDG_CACHE_HOME")
                   ? cachedPatient(parametersOf(BuiltinPatient::TwelveYears),
                                   AnatomyCache::defaultFolder())
                   : builtinPatient(BuiltinPatient::TwelveYears);
    }

    QTemporaryDir m_folder;
    int m_swung = 0;
};

} // namespace carina
