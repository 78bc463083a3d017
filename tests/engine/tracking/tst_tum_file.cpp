#include "engine/tracking/tum_file.h"

#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <sstream>

namespace carina::tum_file_test
{
namespace
{

using namespace std::chrono_literals;

Result<std::vector<PoseSample>> read(const std::string& text)
{
    std::istringstream input{text};
    return readTum(input, "head.txt");
}

Errc errorOf(const std::string& text)
{
    const auto samples = read(text);
    return samples ? Errc::Cancelled : samples.error().code;
}

const std::string kFirst = "1706706430.369 1 2 3 0 0 0 1\n";

} // namespace

class TumFileTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsMetresQuaternionsAndTimesSinceTheFirst()
    {
        // A quarter turn about z, its real part last.
        const auto samples = read("# seconds x y z qx qy qz qw\n\n" + kFirst
                                  + "1706706430.469 0.5 -2e-3 3\t0 0 0.70710678 0.70710678\r\n");
        QVERIFY(samples);
        QCOMPARE(samples->size(), std::size_t{2});
        QCOMPARE(samples->front().time, SessionTime{0ms});
        QVERIFY(samples->back().time - SessionTime{100ms} < 1us);
        QCOMPARE(samples->back().X_FO.translation(), Vec3(0.5, -0.002, 3.0));
        const Vec3 turned = samples->back().X_FO.rotation() * Vec3::UnitX();
        QVERIFY((turned - Vec3::UnitY()).norm() < 1e-7);
    }

    void takesTheFirstOfTwoPosesOfOneTime()
    {
        const auto samples = read("1 1 0 0 0 0 0 1\n1 2 0 0 0 0 0 1\n2 3 0 0 0 0 0 1\n");
        QVERIFY(samples);
        QCOMPARE(samples->size(), std::size_t{2});
        QCOMPARE(samples->front().X_FO.translation().x(), 1.0);
    }

    void refusesWhatIsNoTrajectory_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("code");
        const auto row = [](const char* name, const std::string& text, Errc code) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << int(code);
        };
        row("nothing", "", Errc::FileEmpty);
        row("comments only", "# t x y z\n", Errc::FileEmpty);
        row("seven numbers", "1 0 0 0 0 0 1\n", Errc::FileMalformed);
        row("nine numbers", "1 0 0 0 0 0 0 1 0\n", Errc::FileMalformed);
        row("a word", "1 0 0 here 0 0 0 1\n", Errc::FileMalformed);
        row("commas", "1,0,0,0,0,0,0,1\n", Errc::FileMalformed);
        row("an earlier time", kFirst + "1706706430.368 1 2 3 0 0 0 1\n", Errc::FileMalformed);
        row("not finite", "1 nan 0 0 0 0 0 1\n", Errc::NotFinite);
        row("infinite time", "inf 0 0 0 0 0 0 1\n", Errc::NotFinite);
        row("no rotation", "1 0 0 0 0 0 0 0\n", Errc::NotARotation);
        row("a long quaternion", "1 0 0 0 0 0 0 1.02\n", Errc::NotARotation);
        row("a century later", kFirst + "5e9 1 2 3 0 0 0 1\n", Errc::OutOfRange);
    }

    void refusesWhatIsNoTrajectory()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, code);
        QCOMPARE(int(errorOf(text.toStdString())), code);
    }

    void namesTheFaultyLine()
    {
        const auto samples = read(kFirst + "# here\noops\n");
        QVERIFY(!samples);
        QVERIFY(samples.error().detail.starts_with("head.txt: line 3: "));
    }

    void tellsAMissingFileFromAFolder()
    {
        const QTemporaryDir folder;
        QCOMPARE(
            readTumFile(folder.filePath(QStringLiteral("none.txt")).toStdString()).error().code,
            Errc::FileNotFound);
        QCOMPARE(readTumFile(folder.path().toStdString()).error().code, Errc::FileUnreadable);
    }
};

CARINA_TEST(TumFileTest)

} // namespace carina::tum_file_test

#include "tst_tum_file.moc"
