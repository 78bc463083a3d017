#include "engine/airway/lumen/measured_lumen.h"
#include "engine/airway/lumen/wall_surfaces.h"
#include "engine/airway/tube/tube_in_lumen.h"
#include "engine/anatomy/airway/centreline.h"
#include "engine/anatomy/chest/chest_region.h"
#include "engine/anatomy/laryngoscopy/laryngoscopy_path.h"
#include "engine/anatomy/patient/body_plan.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/anatomy/patient/patient_dimensions.h"
#include "engine/anatomy/patient/patient_name.h"
#include "engine/geometry/mesh/surface_tree.h"
#include "evaluation/intubation/motion_script.h"
#include "evaluation/intubation/motion_truth.h"
#include "tests/engine/airway/tube/feeding_hand.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <vector>

namespace carina::tube_in_patients_test
{
namespace
{

constexpr Length kOutside = millimetres(0.5);
constexpr double kMostOutside = 0.04; ///< share of the places of the tube between teeth and carina
constexpr int kLookEach = 100;        ///< steps from one look at the triangles to the next
constexpr Length kLeap = millimetres(6.0); ///< of the tip in a step, beside what the hand goes
constexpr Length kMostLeap = millimetres(20.0);
constexpr Length kMostTooLarge = millimetres(2.0);
constexpr int kMostLeaps = 3; ///< in a motion, as where the tip goes over to another way

/// A patient, the tube that fits, and the lumen for it.
struct Patient {
    Patient(const PatientParameters& who, Length inner)
        : anatomy{patientFor(who).value()},
          held{heldJaw(anatomy.contentHash)},
          motion{std::make_shared<const MotionPatient>(motionPatient(anatomy, held).value())},
          tube{motionTube(anatomy.landmarks, inner, tubeOfSize(inner)->length).value()},
          size{tubeOfSize(inner).value()},
          lumen{measuredLumen(anatomy.parts, anatomy.landmarks, 0.5 * tube.outerDiameter).value()}
    {
        size.outer = tube.outerDiameter;
        size.length = lengthOf(tube.p_E_centre);
    }

    Anatomy anatomy;
    RigidTransform held;
    std::shared_ptr<const MotionPatient> motion;
    TubeShape tube;
    TubeSize size;
    AirwayLumen lumen;
};

/// The tissue at a moment of a motion.
struct Tissue {
    Tissue(const Patient& patient, const IntubationMotion& motion, const MotionMoment& moment)
        : throat{patient.motion->throat, moment.X_AJ * patient.held.inverse(),
                 NeckField{patient.motion->airway.p_A_glottis, patient.motion->airway.p_A_incisors,
                           moment.head}}
    {
        const UpperAirway airway = followed(patient.motion->upper, throat);
        if (isInMouth(airway, motion.blade(), moment.X_AL))
            blade = bladeInTissue(airway, motion.blade(), moment.X_AL);
    }
    [[nodiscard]] Vec3 at(const Vec3& p_A, AirwayTissue tissue) const
    {
        const Vec3 p_A_moved = tissueMotion(changes, throat)(p_A, tissue);
        return blade.isThere() ? bladePushing(blade)(p_A_moved, tissue) : p_A_moved;
    }

    AirwayField changes;
    FollowingThroat throat;
    BladeField blade;
};

AirwayTissue tissueOfPart(const AnatomyPart& part)
{
    if (part.role == PartRole::Mandible || movesWithMandible(part))
        return AirwayTissue::Throat;
    const ChestRegion region = regionOf(part);
    return region == ChestRegion::Bronchi ? AirwayTissue::Windpipe
                                          : airwayTissueOf(region).value_or(AirwayTissue::Pharynx);
}

/// The triangles that line the airway, where tissue lies at a moment.
class Walls
{
public:
    Walls(const Patient& patient, const Tissue& tissue)
    {
        for (const AnatomyPart& part : patient.anatomy.parts) {
            if (!isAirwayWall(part.role))
                continue;
            TriangleMesh mesh = part.levels.front();
            const AirwayTissue of = tissueOfPart(part);
            for (Vec3f& p : mesh.positions)
                p = tissue.at(p.cast<double>(), of).cast<float>();
            m_trees.emplace_back(mesh);
        }
    }
    /// From the nearest triangle; below 0 behind it.
    [[nodiscard]] double distanceOf(const Vec3& p_A) const
    {
        double nearest = 1.0;
        for (const SurfaceTree& tree : m_trees)
            if (const auto there = tree.nearestTo(p_A)) {
                const Vec3 way = p_A - there->p;
                const double distance = std::copysign(way.norm(), way.dot(there->normal));
                if (std::abs(distance) < std::abs(nearest))
                    nearest = distance;
            }
        return nearest;
    }

private:
    std::vector<SurfaceTree> m_trees;
};

/// What became of a tube in a motion.
struct Ran {
    bool isRight = false;
    TubeTip tip; ///< in the end
    int places = 0;
    int outside = 0; ///< by more than kOutside, where it is not too narrow anyway
    int leaps = 0;   ///< steps in which the tip goes more than kLeap
    Length farthest{};
};

/// Counts how far a tip goes in a step, beside what the hand does, while it is in the body.
class Leaps
{
public:
    void take(const TubeInLumen& tube, const RigidTransform& X_AE, Ran& ran)
    {
        const Vec3 p_A_tip = tube.constrained().back();
        const Vec3 p_A_hand = X_AE.translation();
        if (m_wasInside && tube.tip().isPastTeeth) {
            const Length beside =
                metres((p_A_tip - m_p_A_tip).norm() - (p_A_hand - m_p_A_hand).norm());
            ran.leaps += beside > kLeap;
            ran.farthest = std::max(ran.farthest, beside);
        }
        m_wasInside = tube.tip().isPastTeeth;
        m_p_A_tip = p_A_tip;
        m_p_A_hand = p_A_hand;
    }

private:
    bool m_wasInside = false;
    Vec3 m_p_A_tip = Vec3::Zero();
    Vec3 m_p_A_hand = Vec3::Zero();
};

void look(const Patient& patient, const TubeInLumen& tube, const MovedLumen& lumen,
          const Tissue& tissue, Ran& ran)
{
    const Walls walls{patient, tissue};
    const MovedWay& trunk = lumen.way(AirwayWay::Trunk);
    for (const Vec3& p_A : tube.constrained()) {
        std::size_t segment = trunk.nearestSegment(p_A);
        const double along = trunk.alongAt(p_A, segment);
        if (along <= lumen.teeth || along >= trunk.along.back() - 0.012)
            continue;
        const double tooNarrow = std::max(-lumen.sectionAt(AirwayWay::Trunk, along).spare, 0.0);
        const double beyond = patient.size.outerRadius().si - walls.distanceOf(p_A);
        ++ran.places;
        ran.outside += beyond > kOutside.si + tooNarrow;
    }
}

Ran run(const Patient& patient, const NamedMotion& named, bool looks)
{
    std::mt19937 random = generatorOf(named.kind, 1);
    const auto parameters = drawnParameters(named.kind, random);
    const auto motion = scriptedMotion(named.kind, parameters, patient.motion, patient.tube,
                                       std::uint32_t(random()));
    if (!motion)
        return {};
    TubeInLumen tube{patient.size, patient.tube.p_E_centre};
    Ran ran;
    Leaps leaps;
    MovedLumen lumen;
    const auto steps = std::int64_t(toSeconds(motion->length()) / kTubeStep);
    for (std::int64_t i = 0; i <= steps; ++i) {
        const MotionMoment moment = motion->at(fromSeconds(double(i) * kTubeStep));
        if (i % 2 == 0) {
            const Tissue tissue{patient, *motion, moment};
            lumen = moved(patient.lumen, tissueMotion(tissue.changes, tissue.throat),
                          bladePushing(tissue.blade));
        }
        const NeckField neck{patient.motion->airway.p_A_glottis,
                             patient.motion->airway.p_A_incisors, moment.head};
        tube.step(moment.X_AE, lumen, centreIn(neck, patient.tube));
        leaps.take(tube, moment.X_AE, ran);
        const bool isInTrunk = tube.tip().isPastTeeth && tube.tip().way != AirwayWay::Oesophagus;
        if (looks && i % kLookEach == 0 && isInTrunk)
            look(patient, tube, lumen, Tissue{patient, *motion, moment}, ran);
    }
    ran.tip = tube.tip();
    ran.isRight = tube.tip().seat == seatOf(truthOf(*motion).outcome);
    return ran;
}

const Patient& patientOf(BuiltinPatient which)
{
    static const Patient child{parametersOf(BuiltinPatient::TwelveYears),
                               usualTube(12.0, Sex::Male)};
    static const Patient adult{parametersOf(BuiltinPatient::Adult), usualTube(40.0, Sex::Male)};
    return which == BuiltinPatient::Adult ? adult : child;
}

/// The lumen as the tip passes the cords in a good intubation.
MovedLumen lumenBeforeBlade(const Patient& patient)
{
    std::mt19937 random = generatorOf(MotionKind::Good, 1);
    const auto motion = scriptedMotion(MotionKind::Good, drawnParameters(MotionKind::Good, random),
                                       patient.motion, patient.tube, std::uint32_t(random()));
    const auto events = truthOf(*motion).events;
    const auto passage = std::ranges::find(events, TrueStep::ThroughCords, &TrueEvent::step);
    const Tissue tissue{patient, *motion, motion->at(passage->at)};
    return moved(patient.lumen, tissueMotion(tissue.changes, tissue.throat),
                 bladePushing(tissue.blade));
}

/// Curved as tubes are that are sold.
TubeRest soldCurve(const TubeSize& size)
{
    return {size.length, {1.0 / 0.14, 1.0 / 0.14}, size.outer};
}

void patients()
{
    QTest::addColumn<int>("which");
    QTest::newRow("twelve years") << int(BuiltinPatient::TwelveYears);
    QTest::newRow("adult") << int(BuiltinPatient::Adult);
}

} // namespace

class TestTubeInPatients : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Where the real one ended: in all motions but those in which it ends at the cords themselves.
    /// On its way there it leaps where it goes over to another way, and nowhere else.
    void endsWhereTheRealOneDoes_data() { patients(); }
    void endsWhereTheRealOneDoes()
    {
        QFETCH(int, which);
        for (const NamedMotion& named : kNamedMotions) {
            const Ran ran = run(patientOf(BuiltinPatient(which)), named, false);
            const QString told = QStringLiteral("%1: %2 leaps, %3 mm at most")
                                     .arg(QString::fromUtf8(named.name))
                                     .arg(ran.leaps)
                                     .arg(inMillimetres(ran.farthest), 0, 'f', 1);
            qInfo("%s", qPrintable(told));
            QVERIFY2(ran.isRight || named.kind == MotionKind::CuffAboveCords, qPrintable(told));
            QVERIFY2(ran.leaps <= kMostLeaps && ran.farthest < kMostLeap, qPrintable(told));
        }
    }

    void isStoppedAtTheCricoidWhereItIsTooLarge_data()
    {
        QTest::addColumn<QString>("words");
        for (const char* words : {"1 year, 75 cm, girl", "6 years, 116 cm, girl"})
            QTest::newRow(words) << QString::fromLatin1(words);
    }
    /// In whom it is the narrowest place below the cords: of the sizes in turn the usual one goes
    /// through, the first that does not is stopped behind the cords and no farther down than the
    /// cricoid's lower border (sections are 4 mm apart), and none of the larger ones goes as far.
    void isStoppedAtTheCricoidWhereItIsTooLarge()
    {
        QFETCH(QString, words);
        constexpr Length kSections = millimetres(4.0);
        const PatientParameters who = parametersFromWords(words.toStdString()).value();
        const PatientDimensions child = dimensionsFor(who).value();
        const Length cricoid = child.cordsToCarina - child.tracheaLength;
        const auto good = std::ranges::find(kNamedMotions, MotionKind::Good, &NamedMotion::kind);
        std::optional<Length> stoppedAt;
        for (Length inner = child.tubeInnerDiameter;
             inner <= child.tubeInnerDiameter + kMostTooLarge; inner = inner + kTubeSizeStep) {
            const TubeTip tip = run(Patient{who, inner}, *good, false).tip;
            qInfo("%.1f mm: %s %.1f mm behind the cords", inMillimetres(inner),
                  tip.isStopped ? "stopped" : "goes on to", inMillimetres(tip.pastGlottis));
            QVERIFY(tip.isStopped || !stoppedAt);
            QVERIFY(!tip.isStopped || inner > child.tubeInnerDiameter);
            if (!tip.isStopped)
                continue;
            QVERIFY(tip.pastGlottis < stoppedAt.value_or(cricoid + kSections));
            QVERIFY(stoppedAt || tip.pastGlottis > Length{});
            stoppedAt = stoppedAt.value_or(tip.pastGlottis);
        }
        QVERIFY(stoppedAt);
    }

    /// At the teeth, once it rests; in steps of 1.5 mm.
    void isAsDeepAsItIsPushed_data()
    {
        QTest::addColumn<QString>("words");
        QTest::addColumn<double>("inner_mm");
        for (const double inner_mm : {6.0, 6.5})
            QTest::addRow("child, %.1f mm", inner_mm)
                << QStringLiteral("12 years, 150 cm, boy") << inner_mm;
        for (const double inner_mm : {6.0, 6.5, 7.0, 7.5, 8.0})
            QTest::addRow("adult, %.1f mm", inner_mm)
                << QStringLiteral("40 years, 175 cm, man") << inner_mm;
    }
    void isAsDeepAsItIsPushed()
    {
        QFETCH(QString, words);
        QFETCH(double, inner_mm);
        constexpr Length kDepth = millimetres(2.0);
        constexpr Length kAboveCords = millimetres(2.5); // where it lies less firmly
        const Patient patient{parametersFromWords(words.toStdString()).value(),
                              millimetres(inner_mm)};
        const MovedLumen lumen = lumenBeforeBlade(patient);
        const test::Mouth mouth = test::mouthOf(lumen);
        const TubeRest rest = soldCurve(patient.size);
        TubeInLumen tube{patient.size, centrelineOfTube(rest)};
        double inside = -0.02;
        for (const double depth : {0.12, 0.15, 0.18}) {
            for (; inside < depth; inside += 0.0015)
                tube.step(test::fed(mouth, rest, inside), lumen);
            for (int i = 0; i < 60; ++i)
                tube.step(test::fed(mouth, rest, depth), lumen);
            const Length off = metres(std::abs(tube.tip().depth.si - depth));
            qInfo("%.0f mm: off by %.1f mm", 1e3 * depth, inMillimetres(off));
            QVERIFY(off < (depth < 0.14 ? kAboveCords : kDepth));
        }
    }

    /// Measured against the triangles, and not against the sections in which the rod is held.
    void staysInsideOfTheTriangles_data() { patients(); }
    void staysInsideOfTheTriangles()
    {
        QFETCH(int, which);
        const auto good = std::ranges::find(kNamedMotions, MotionKind::Good, &NamedMotion::kind);
        const Ran ran = run(patientOf(BuiltinPatient(which)), *good, true);
        QVERIFY(ran.places > 200);
        QVERIFY2(ran.outside < kMostOutside * ran.places,
                 qPrintable(QStringLiteral("%1 of %2").arg(ran.outside).arg(ran.places)));
        qInfo("%d of %d places are more than 0.5 mm outside", ran.outside, ran.places);
    }
};

CARINA_TEST(TestTubeInPatients)

} // namespace carina::tube_in_patients_test

#include "tst_tube_in_patients.moc"
