#include "apps/lab/commands.h"
#include "engine/geometry/vec.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <cmath>
#include <random>

namespace carina::lab::deform_command_test
{
namespace
{

constexpr double kGreatestRatio = 0.46; ///< of residual to motion, when other people were fitted to
constexpr double kGreatestGap_mm = 1.0;
constexpr double kTolerance_mm = 0.006; ///< figures of cases.csv are rounded to 0.01

/// How somebody breathes, in the words of docs/deformation.md.
struct Breath {
    double frontShare;
    double ribs;
    double gravity;
};

double smooth(double x)
{
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double bulging(double x) { return std::pow(4.0 * x * (1.0 - x), 2.0); }

constexpr double kHalfWidth = 0.6; ///< of the box of the landmarks, of its height

/// The field of docs/deformation.md at (u, v, h) in a box of unit height, written out once more:
/// (out, back, down) at amplitude 1.
Vec3 fieldAt(double u, double v, double h, const Breath& breath)
{
    const double beyond = std::max(std::abs(u) - 0.3, 0.0);
    const double rho =
        16.0 * beyond * beyond + 6.25 * std::pow(v - 0.55, 2.0) + 16.0 * std::pow(h - 0.45, 2.0);
    const double away = 1.0 - 1.0 / std::pow(1.0 + rho, 2.0);
    const double ribs = breath.ribs * smooth(3.0 * h) * (1.0 - smooth((v - 0.3) / 0.7));
    const double behind = smooth((v + 0.2) / 1.4);
    const double descent = 0.075 * (breath.frontShare + (1.0 - breath.frontShare) * behind);
    const double heart = 0.3 * std::pow(1.0 - u * u, 2.0);
    return away
           * Vec3{u * (0.012 * ribs + kHalfWidth * 0.28 * bulging(h) * descent),
                  -0.018 * ribs + 0.04 * breath.gravity * bulging(v) * bulging(h),
                  descent * smooth(h) * (1.0 - heart)};
}

/// Landmarks in a box of 240 x 160 x 200 mm that move by the field, as a file has them; apart by
/// some noise.
QByteArray landmarksMovedBy(const Breath& breath, double amplitude, unsigned seed, double noise_mm)
{
    std::mt19937 random{seed};
    std::uniform_real_distribution<double> share{0.0, 1.0};
    std::normal_distribution<double> noise{0.0, noise_mm};
    QByteArray text = "i,ee_x_mm,ee_y_mm,ee_z_mm,ei_x_mm,ei_y_mm,ei_z_mm\n";
    for (int n = 0; n < 300; ++n) {
        Vec3 q{2.0 * share(random) - 1.0, share(random), share(random)};
        if (n < 2) // so that the box is known
            q = n == 0 ? Vec3{-1.0, 0.0, 0.0} : Vec3{1.0, 1.0, 1.0};
        const Vec3 p{120.0 * q.x() + 140.0, 160.0 * q.y() + 60.0, 200.0 * q.z() + 20.0};
        const Vec3 d = 200.0 * amplitude * fieldAt(q.x(), q.y(), q.z(), breath)
                       + Vec3{noise(random), noise(random), noise(random)};
        text += QByteArray::number(n);
        for (const Vec3& place : {p, Vec3{p + d}})
            for (int axis = 0; axis < 3; ++axis)
                text += ',' + QByteArray::number(place[axis], 'g', 17);
        text += '\n';
    }
    return text;
}

Result<QJsonObject> deformWith(const QStringList& arguments)
{
    return deformCommand().run(arguments);
}

double number(const QJsonObject& object, const char* key)
{
    return object.value(QLatin1StringView{key}).toDouble(std::nan(""));
}

} // namespace

class TestDeformCommand : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { m_folder.emplace(); }
    void findsNoResidualWhereLandmarksMoveByTheField();
    void comparesWithSimplerModels();
    void learnsHowOthersBreathe();
    void passesOverItsOwnLandmarks();
    void leavesEachFileOutInTurn();
    void refusesWhatItCannotUse_data();
    void refusesWhatItCannotUse();
    void namesTheWordThatIsWrong();
    void tellsAFolderThatIsNotThereFromAnEmptyOne();
    void followsTheLungsOfPeople_data();
    void followsTheLungsOfPeople();
    void keepsRealLobesTogether();

private:
    std::optional<test::ScratchFolder> m_folder;
};

void TestDeformCommand::findsNoResidualWhereLandmarksMoveByTheField()
{
    const QString file =
        m_folder->write("a.csv", landmarksMovedBy({0.11, 0.09, 0.15}, 1.4, 3, 0.0));
    const QJsonObject found = deformWith({QStringLiteral("--landmarks"), file}).value();
    QCOMPARE(found.value(QStringLiteral("schema")), QStringLiteral("carina.deform/1"));
    QCOMPARE(number(found, "landmarks"), 300.0);
    QVERIFY(std::abs(number(found, "amplitude") - 1.4) < 1e-9);
    QVERIFY(number(found, "mean_motion_mm") > 1.0);
    QVERIFY(number(found, "max_residual_mm") < 1e-9);
    QVERIFY(number(found, "ratio") < 1e-9);
}

/// Landmarks that a shift to the feet moves, growing from the apex: it leaves nothing of that, and
/// neither does the affine map that it is; of one with another direction the affine map alone.
void TestDeformCommand::comparesWithSimplerModels()
{
    const auto movedBy = [&](const Vec3& growing) {
        std::mt19937 random{17};
        std::uniform_real_distribution<double> place_mm{0.0, 200.0};
        QByteArray text = "i,ee_x_mm,ee_y_mm,ee_z_mm,ei_x_mm,ei_y_mm,ei_z_mm\n";
        for (int n = 0; n < 50; ++n) {
            const double h = n == 0 ? 0.0 : place_mm(random);
            const Vec3 p{place_mm(random), place_mm(random), h};
            text += QByteArray::number(n);
            for (const Vec3& at : {p, Vec3{p + h * growing}})
                for (int axis = 0; axis < 3; ++axis)
                    text += ',' + QByteArray::number(at[axis], 'g', 17);
            text += '\n';
        }
        const QString file = m_folder->write("shift.csv", text);
        return deformWith({QStringLiteral("--landmarks"), file}).value();
    };
    const QJsonObject down = movedBy({0.0, 0.0, 0.05});
    QVERIFY(number(down, "ratio_shift") < 1e-9);
    QVERIFY(number(down, "ratio_affine") < 1e-9);
    // Of (0, 0.03, 0.04) per length, of which 0.05 is the whole, 0.03 is left.
    const QJsonObject aslant = movedBy({0.0, 0.03, 0.04});
    QVERIFY(std::abs(number(aslant, "ratio_shift") - 0.6) < 1e-9);
    QVERIFY(number(aslant, "ratio_affine") < 1e-9);
}

void TestDeformCommand::learnsHowOthersBreathe()
{
    const Breath breath{0.4, -0.2, 0.5};
    m_folder->write("b.csv", landmarksMovedBy(breath, 0.7, 5, 0.0));
    m_folder->write("c.csv", landmarksMovedBy(breath, 2.1, 7, 0.0));
    const QString file = m_folder->write("a.csv", landmarksMovedBy(breath, 1.0, 11, 0.1));
    const QJsonObject found =
        deformWith({QStringLiteral("--landmarks"), file, QStringLiteral("--fit"), m_folder->path()})
            .value();
    const QJsonObject constants = found.value(QStringLiteral("constants")).toObject();
    QVERIFY(std::abs(number(constants, "front_share") - breath.frontShare) < 1e-6);
    QVERIFY(std::abs(number(constants, "ribs") - breath.ribs) < 1e-6);
    QVERIFY(std::abs(number(constants, "gravity") - breath.gravity) < 1e-6);
    QCOMPARE(constants.value(QStringLiteral("fitted_to")).toArray(),
             (QJsonArray{QStringLiteral("b.csv"), QStringLiteral("c.csv")}));
    // The mean length of noise of 0.1 mm along each axis: 0.1 sqrt(8 / pi).
    QVERIFY(std::abs(number(found, "mean_residual_mm") - 0.1596) < 0.02);
}

void TestDeformCommand::passesOverItsOwnLandmarks()
{
    const QByteArray own = landmarksMovedBy({0.1, 0.3, 0.2}, 1.0, 3, 0.0);
    const QString file = m_folder->write("a.csv", own);
    m_folder->write("copy.csv", own);
    const auto found = deformWith(
        {QStringLiteral("--landmarks"), file, QStringLiteral("--fit"), m_folder->path()});
    QVERIFY(!found);
    QCOMPARE(found.error().code, Errc::TooFewLandmarks);
}

void TestDeformCommand::leavesEachFileOutInTurn()
{
    m_folder->write("a.csv", landmarksMovedBy({0.1, 0.3, 0.2}, 1.0, 3, 0.0));
    m_folder->write("b.csv", landmarksMovedBy({0.5, 0.0, 0.0}, 1.0, 5, 0.0));
    m_folder->write("sizes.csv", "case,mm\n1,2\n");
    const QJsonObject found = deformWith({QStringLiteral("--fit"), m_folder->path()}).value();
    QCOMPARE(found.value(QStringLiteral("left_out")).toArray(),
             QJsonArray{QStringLiteral("sizes.csv")});
    const QJsonArray cases = found.value(QStringLiteral("cases")).toArray();
    QCOMPARE(cases.size(), 2);
    const QJsonObject first = cases[0].toObject();
    QCOMPARE(first.value(QStringLiteral("file")), QStringLiteral("a.csv"));
    const QJsonObject constants = first.value(QStringLiteral("constants")).toObject();
    QVERIFY(std::abs(number(constants, "front_share") - 0.5) < 1e-6);
    QVERIFY(number(first, "ratio") > 0.1);
    const QJsonObject all = found.value(QStringLiteral("constants")).toObject();
    QVERIFY(number(all, "front_share") > 0.1 && number(all, "front_share") < 0.5);
}

void TestDeformCommand::refusesWhatItCannotUse_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<Errc>("code");
    const QByteArray header = "ee_x_mm,ee_y_mm,ee_z_mm,ei_x_mm,ei_y_mm,ei_z_mm\n";
    QTest::newRow("nothing") << QByteArray{} << Errc::FileEmpty;
    QTest::newRow("no landmarks") << header << Errc::TooFewLandmarks;
    QTest::newRow("in one plane") << header + "1,2,3,1,2,3\n4,2,6,4,2,6\n" << Errc::TooFewLandmarks;
    QTest::newRow("words") << header + "1,2,3,4,five,6\n" << Errc::FileMalformed;
    QTest::newRow("nowhere") << header + "1,2,3,4,nan,6\n" << Errc::NotFinite;
    QTest::newRow("other columns") << QByteArray{"x,y\n1,2\n"} << Errc::FileMalformed;
}

void TestDeformCommand::refusesWhatItCannotUse()
{
    QFETCH(QByteArray, text);
    QFETCH(Errc, code);
    const auto found = deformWith({QStringLiteral("--landmarks"), m_folder->write("a.csv", text)});
    QVERIFY(!found);
    QCOMPARE(found.error().code, code);
    QVERIFY(found.error().detail.find("a.csv") != std::string::npos);
    for (const QStringList& arguments :
         {QStringList{}, QStringList{QStringLiteral("--landmarks")},
          QStringList{QStringLiteral("--fit"), m_folder->path(), QStringLiteral("more")},
          QStringList{QStringLiteral("--fit"), m_folder->path(), QStringLiteral("--inspired-ml"),
                      QStringLiteral("500")},
          QStringList{QStringLiteral("--fissures"), m_folder->path(),
                      QStringLiteral("--inspired-ml"), QStringLiteral("much")}})
        QCOMPARE(deformWith(arguments).error().code, Errc::WrongOption);
}

void TestDeformCommand::namesTheWordThatIsWrong()
{
    const auto refusal = [](const QStringList& arguments) {
        return deformWith(arguments).error().detail;
    };
    const QString absent = m_folder->filePath("absent.csv");
    QCOMPARE(refusal({QStringLiteral("--landmarks"), absent}),
             "There is no file " + absent.toStdString() + ".");
    QCOMPARE(refusal({QStringLiteral("--bogus")}), std::string{"deform has no option --bogus."});
    QVERIFY(refusal({QStringLiteral("--landmarks")}).find("'--landmarks'") != std::string::npos);
    QVERIFY(refusal({}).starts_with("No file and no folder is named. deform needs"));
}

void TestDeformCommand::tellsAFolderThatIsNotThereFromAnEmptyOne()
{
    const QString absent = m_folder->filePath("absent");
    const auto refusal = [](const QString& folder) {
        return deformWith({QStringLiteral("--fit"), folder}).error().detail;
    };
    QCOMPARE(refusal(absent), "There is no folder " + absent.toStdString() + ".");
    QCOMPARE(refusal(m_folder->path()),
             m_folder->path().toStdString() + " holds no file with landmarks.");
}

// DIR-Lab's cases 1 to 5; their mean motion as their authors give it.
void TestDeformCommand::followsTheLungsOfPeople_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<double>("meanMotion_mm");
    const std::array means_mm{3.84, 4.36, 6.84, 9.82, 7.42};
    for (std::size_t n = 0; n < means_mm.size(); ++n)
        QTest::addRow("case %d", int(n) + 1)
            << QStringLiteral("case%1_refined.csv").arg(n + 1) << means_mm[n];
}

void TestDeformCommand::followsTheLungsOfPeople()
{
    const auto folder = test::testData("lung-motion");
    if (!folder)
        QSKIP("lung-motion is not there");
    QFETCH(QString, file);
    QFETCH(double, meanMotion_mm);
    const QString path = QString::fromStdString(folder->string());
    const QJsonObject found = deformWith({QStringLiteral("--landmarks"), QDir{path}.filePath(file),
                                          QStringLiteral("--fit"), path})
                                  .value();
    QVERIFY(std::abs(number(found, "mean_motion_mm") - meanMotion_mm) < kTolerance_mm);
    QVERIFY2(number(found, "mean_residual_mm") <= kGreatestRatio * meanMotion_mm,
             qPrintable(QString::number(number(found, "ratio"))));
    const QJsonObject constants = found.value(QStringLiteral("constants")).toObject();
    QCOMPARE(constants.value(QStringLiteral("fitted_to")).toArray().size(), 4);
}

// After twice an adult's tidal volume.
void TestDeformCommand::keepsRealLobesTogether()
{
    const auto folder = test::testData("anatomy/lungs");
    if (!folder)
        QSKIP("the real lungs are not here");
    const QJsonObject found =
        deformWith({QStringLiteral("--fissures"), QString::fromStdString(folder->string()),
                    QStringLiteral("--inspired-ml"), QStringLiteral("1000")})
            .value();
    const QJsonArray fissures = found.value(QStringLiteral("fissures")).toArray();
    QCOMPARE(fissures.size(), 3); // right lower to upper and middle lobe, left lower to upper
    for (const auto& fissure : fissures) {
        const QJsonObject fit = fissure.toObject();
        QVERIFY(number(fit, "points") > 50.0);
        QVERIFY(number(fit, "mean_slide_mm") > 0.05);
        QVERIFY2(number(fit, "max_gap_mm") < kGreatestGap_mm
                     && number(fit, "max_overlap_mm") < kGreatestGap_mm,
                 QJsonDocument{fit}.toJson().constData());
    }
}

CARINA_TEST(TestDeformCommand)

} // namespace carina::lab::deform_command_test

#include "tst_deform_command.moc"
