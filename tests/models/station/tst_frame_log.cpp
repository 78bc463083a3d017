#include "models/station/frame_log.h"

#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <QFile>
#include <QTemporaryDir>

namespace carina::frame_log_test
{

class TestFrameLog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsWhatItWroteToTheLastDigit()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("frames.csv"));
        LoggedFrame full;
        full.local = LocalTime{Duration{123'456'789'012'345'678}};
        full.session = SessionTime{Duration{-5}};
        full.level = 2;
        full.amplitude = {0.1F, -1.0F / 3.0F};
        full.X_AE = RigidTransform{rotationFromVector(Vec3{0.1, 0.2, -0.3}), Vec3{1e-9, -0.2, 3.0}};
        full.sampleAge = Duration{16'000'001};
        full.X_AV = RigidTransform{rotationFromVector(Vec3{0.3, 0.0, 0.1}), Vec3{0.1, 0.2, 0.3}};
        full.volume_ml = {1234.5678901234567, 0.1};
        const LoggedFrame bare; // no tube, no age
        QVERIFY(writeFrames(path, {full, bare}).has_value());

        const auto read = readFrames(path);
        QVERIFY(read.has_value());
        QCOMPARE(read->size(), std::size_t{2});
        const LoggedFrame& first = read->front();
        QVERIFY(first.local == full.local && first.session == full.session);
        QCOMPARE(first.level, 2);
        QVERIFY(first.amplitude == full.amplitude);
        QVERIFY(first.volume_ml == full.volume_ml);
        QVERIFY(first.sampleAge == full.sampleAge);
        QVERIFY(first.X_AE->translation() == full.X_AE->translation());
        constexpr double kRounding_rad = 1e-15; // a unit quaternion brought to unit length again
        QVERIFY(angleBetween(first.X_AE->rotation(), full.X_AE->rotation()).si < kRounding_rad);
        QVERIFY(first.X_AV->translation() == full.X_AV->translation());
        QVERIFY(angleBetween(first.X_AV->rotation(), full.X_AV->rotation()).si < kRounding_rad);
        QVERIFY(!read->back().X_AE.has_value() && !read->back().X_AV.has_value());
        QVERIFY(!read->back().sampleAge.has_value());
    }

    void refusesWhatIsNoFrameLog_data()
    {
        QTest::addColumn<QByteArray>("tail");
        QTest::newRow("a cell too few") << QByteArray{"1,2,0,0,0,,,,,,,,,0,,,,,,,\n"};
        QTest::newRow("a word for a number") << QByteArray{"1,2,0,zero,0,,,,,,,,,0,0,,,,,,,\n"};
        QTest::newRow("a rotation of no length")
            << QByteArray{"1,2,0,0,0,0,0,0,0,0,0,0,,0,0,,,,,,,\n"};
        QTest::newRow("a rotation that is not finite")
            << QByteArray{"1,2,0,0,0,0,0,0,nan,0,0,1,,0,0,,,,,,,\n"};
    }

    void refusesWhatIsNoFrameLog()
    {
        QFETCH(QByteArray, tail);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("frames.csv"));
        QVERIFY(writeFrames(path, {}).has_value());
        QFile file{path};
        QVERIFY(file.open(QIODevice::Append));
        file.write(tail);
        file.close();
        const auto read = readFrames(path);
        QVERIFY(!read.has_value());
        QCOMPARE(read.error().code, Errc::FileMalformed);
        QVERIFY(read.error().detail.find("line 2") != std::string::npos);
    }

    void namesTheFileThatIsNotThere()
    {
        const auto read = readFrames(QStringLiteral("/nowhere/frames.csv"));
        QCOMPARE(read.error().code, Errc::FileNotFound);
        QVERIFY(read.error().detail.starts_with("/nowhere/frames.csv"));
        QCOMPARE(writeFrames(QStringLiteral("/nowhere/frames.csv"), {}).error().code,
                 Errc::FileUnwritable);
    }
};

CARINA_TEST(TestFrameLog)

} // namespace carina::frame_log_test

#include "tst_frame_log.moc"
