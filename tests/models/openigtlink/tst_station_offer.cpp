#include "models/openigtlink/station_offer.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/lungs/drawing/chest_drawing.h"
#include "engine/tracking/igtl/igtl_pose.h"
#include "tests/support/test_class.h"

namespace carina::station_offer_test
{
namespace
{

using std::chrono::milliseconds;

constexpr Duration kSince1970 = std::chrono::seconds{1'700'000'000};
constexpr double kSinglePrecision = 1e-4; ///< of a volume, relative

/// The volume of an offered surface in litres, by the tetrahedra over its polygons.
double litresOf(const IgtlPolyData& data)
{
    TriangleMesh mesh; // in millimetres
    for (const auto& p : data.points)
        mesh.positions.emplace_back(p[0], p[1], p[2]);
    const auto& numbers = data.cells[kIgtlPolygons].numbers;
    for (std::size_t i = 0; i + 3 < numbers.size(); i += 4)
        mesh.triangles.push_back({numbers[i + 1], numbers[i + 2], numbers[i + 3]});
    return 1e-6 * signedVolume(mesh);
}

PersonPose personPose(ObjectKind kind, std::string name)
{
    PersonPose person;
    person.kind = kind;
    person.ownerName = std::move(name);
    person.X_AO = RigidTransform::translation({0.1, 0.2, 0.3});
    return person;
}

} // namespace

class StationOfferTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        m_patient =
            PatientModel::of(builtinPatient(BuiltinPatient::TwelveYears).value(), millimetres(6.5))
                .value();
    }

    void namesToolsAndTurnsThemIntoSlicersAxes()
    {
        StationMoment moment;
        moment.tube = PoseSample{.X_FO = RigidTransform::translation({0.01, 0.02, 0.03})};
        moment.jaw = PoseSample{.validity = Validity::Lost};
        moment.people = {personPose(ObjectKind::Head, "Anna"), personPose(ObjectKind::Tube, "Anna"),
                         personPose(ObjectKind::Stylus, "Aleksandra\u00e9\u00e9")};
        const auto offer = StationOffer{}.at(*m_patient, moment, kSince1970);
        QCOMPARE(offer->stamp, igtlStamp(kSince1970));
        QCOMPARE(offer->tools.size(), std::size_t{4});
        QCOMPARE(offer->tools[0].name, std::string{"Tube"});
        QVERIFY(offer->tools[0].X_RO.translation().isApprox(Vec3{-0.01, -0.02, 0.03}));
        QVERIFY(offer->tools[0].isSeen);
        QCOMPARE(offer->tools[1].name, std::string{"Jaw"});
        QVERIFY(!offer->tools[1].isSeen);
        QCOMPARE(offer->tools[2].name, std::string{"Head Anna"});
        QVERIFY(offer->tools[2].X_RO.translation().isApprox(Vec3{-0.1, -0.2, 0.3}));
        // 7 + 10 + 2 bytes: the second of the last letters would end behind the 20th.
        QCOMPARE(offer->tools[3].name, std::string{"Stylus Aleksandra\u00e9"});
    }

    void offersTheLandmarksOfTheAirway()
    {
        const auto offer = StationOffer{}.at(*m_patient, {}, kSince1970);
        const auto& points = offer->landmarks->points;
        QCOMPARE(points.size(), std::size_t{3});
        QCOMPARE(points[1].name, std::string{"Glottis"});
        const Vec3& p_A = m_patient->landmarks().p_A_glottis;
        QVERIFY(std::abs(points[1].p[0] + 1e3 * p_A.x()) < 1e-3);
        QVERIFY(std::abs(points[1].p[1] + 1e3 * p_A.y()) < 1e-3);
        QVERIFY(std::abs(points[1].p[2] - 1e3 * p_A.z()) < 1e-3);
    }

    /// Three places of the same patient turned about the hinges of head and neck; the carina stays.
    void offersThemWhereHeadAndNeckHaveTakenThem()
    {
        constexpr double kSmall_mm = 1e-3;
        StationOffer station;
        StationMoment moment;
        const auto at = [&](std::size_t point, Duration later) {
            const auto offer = station.at(*m_patient, moment, kSince1970 + later);
            const auto& p = offer->landmarks->points.at(point).p;
            return Vec3{p[0], p[1], p[2]};
        };
        const auto inR = [](const Vec3& p_A) { return Vec3{1e3 * (axesOfSlicer() * p_A)}; };
        const Vec3 p_R_neutral = at(0, milliseconds{0});
        moment.headPosition = kSniffing;
        const NeckField neck = m_patient->neck(kSniffing);
        const AirwayLandmarks& airway = m_patient->landmarks();
        const Vec3 p_A_incisors = neck.X_AU() * airway.p_A_incisors; // they go with the head
        QVERIFY((at(0, milliseconds{20}) - inR(p_A_incisors)).norm() < kSmall_mm);
        QVERIFY((at(0, milliseconds{20}) - p_R_neutral).norm() > 10.0);
        QVERIFY((at(1, milliseconds{20}) - inR(neck.placed(airway.p_A_glottis))).norm()
                < kSmall_mm);
        QVERIFY((at(2, milliseconds{20}) - inR(airway.p_A_carina)).norm() < kSmall_mm);
        const auto laid = station.at(*m_patient, moment, kSince1970 + milliseconds{40});
        QVERIFY(station.at(*m_patient, moment, kSince1970 + milliseconds{60})->landmarks
                == laid->landmarks); // made once
        moment.headPosition = {};
        QVERIFY((at(0, milliseconds{80}) - p_R_neutral).norm() < kSmall_mm);
    }

    void offersLungsOfTheVolumeThatIsDrawn()
    {
        StationOffer station;
        const LungPair& lungs = m_patient->lungs();
        const std::size_t level = StationOffer::levelOf(*m_patient);
        StationMoment moment;
        moment.pose = lungs.pose(millilitres(0.0), level).value();
        const double rest = litresOf(station.at(*m_patient, moment, kSince1970)->surface->data);
        moment.pose = lungs.pose(millilitres(300.0), level).value();
        const double full =
            litresOf(station.at(*m_patient, moment, kSince1970 + milliseconds{100})->surface->data);
        QVERIFY2(std::abs(full - rest - 0.3) < kSinglePrecision * full,
                 qPrintable(QString::number(full - rest)));
    }

    void makesNewLungsTenTimesASecond()
    {
        StationOffer station;
        std::set<const IgtlOffer::Surface*> surfaces;
        std::vector<std::shared_ptr<const IgtlOffer>> offers;
        for (int ms = 0; ms < 1000; ms += 20) {
            offers.push_back(station.at(*m_patient, {}, kSince1970 + milliseconds{ms}));
            surfaces.insert(offers.back()->surface.get());
            QVERIFY(offers.back()->landmarks == offers.front()->landmarks);
        }
        QCOMPARE(surfaces.size(), std::size_t{10});
    }

private:
    std::optional<PatientModel> m_patient;
};

CARINA_TEST(StationOfferTest)

} // namespace carina::station_offer_test

#include "tst_station_offer.moc"
