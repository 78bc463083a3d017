#pragma once

#include "engine/anatomy/builtin_patient.h"
#include "engine/geometry/rotation.h"
#include "engine/tracking/tracker.h"
#include "models/registration_model.h"

#include <QTemporaryDir>

#include <array>
#include <cmath>
#include <memory>

namespace carina
{

/// A tracker of a stylus and a chin probe whose samples a test writes by hand.
class WrittenTracker : public Tracker
{
public:
    [[nodiscard]] Result<void> start() override { return {}; }
    void stop() override {}
    [[nodiscard]] std::vector<TrackedTool> tools() const override
    {
        return {{"Stylus", ToolRole::Stylus, &m_stylus}, {"Chin", ToolRole::Jaw, &m_chin}};
    }

    mutable PoseHistory m_stylus;
    mutable PoseHistory m_chin;
};

/// A technician's desk without hardware and without time: the manikin truly lies at X_TA, the
/// stylus truly ends at p_SQ, and every sample is exact.
class RegistrationSite
{
public:
    static constexpr Duration kPeriod = std::chrono::microseconds{16'667};

    [[nodiscard]] std::filesystem::path file() const
    {
        return m_folder.filePath(QStringLiteral("site.json")).toStdString();
    }
    [[nodiscard]] const PatientModel& patient() const
    {
        static const PatientModel child = *PatientModel::of(
            std::move(*builtinPatient(BuiltinPatient::TwelveYears)), millimetres(6));
        return child;
    }
    [[nodiscard]] LandmarkCatalogue landmarks() const
    {
        return ribCageCatalogue(metres(1.5), patient().contentHash());
    }

    /// A model on what the file holds now, as a program makes one when it starts.
    [[nodiscard]] std::unique_ptr<RegistrationModel> model()
    {
        return std::make_unique<RegistrationModel>(
            RegistrationModel::Workplace{.file = file(),
                                         .tracker = &m_tracker,
                                         .trackerName = QStringLiteral("Written tracker"),
                                         .clock = [this] { return std::optional{m_now}; },
                                         .landmarks = landmarks()},
            RegistrationModel::siteOf(file(), patient()).value(), patient());
    }

    /// The next sample of the stylus, its tip at a point.
    void tipAt(const Vec3& p_TQ, const Quat& q_TS = Quat::Identity())
    {
        m_now += kPeriod;
        m_tracker.m_stylus.push({.time = m_now, .X_FO = {q_TS, p_TQ - q_TS * p_SQ}});
        m_tracker.m_chin.push({.time = m_now, .X_FO = X_TJ});
    }

    /// Swings the stylus about a divot until the model has seen enough.
    void swing(RegistrationModel& model)
    {
        model.startSwing();
        for (int i = 0; i < 600 && model.isSwinging(); ++i) {
            tipAt({0.1, 0.0, -1.0},
                  rotationFromVector({0.4 * std::cos(0.1 * i), 0.4 * std::sin(0.1 * i), 0.0}));
            model.look();
        }
    }

    /// Holds the tip still, for a little longer than it takes.
    void hold(RegistrationModel& model, const Vec3& p_TQ)
    {
        for (int i = 0; i < 70; ++i) {
            tipAt(p_TQ);
            model.look();
        }
    }

    /// Everything up to the touched landmarks.
    void touchAll(RegistrationModel& model)
    {
        model.useTracker();
        swing(model);
        model.acceptLandmarks();
        for (const Landmark& landmark : landmarks().landmarks)
            hold(model, X_TA * landmark.p_AQ);
    }

    const RigidTransform X_TA{rotationFromVector({0.2, 1.0, -0.4}), {0.05, -0.1, -1.1}};
    const RigidTransform X_TJ{rotationFromVector({0.1, 0.0, 0.3}), {0.0, 0.1, -1.2}};
    const Vec3 p_SQ{0.002, -0.001, -0.12};
    WrittenTracker m_tracker;
    SessionTime m_now{std::chrono::seconds{100}};

private:
    QTemporaryDir m_folder;
};

} // namespace carina
