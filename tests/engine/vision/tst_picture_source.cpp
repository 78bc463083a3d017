#include "engine/vision/picture_source.h"
#include "evaluation/vision/video_writer.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <fstream>

namespace carina::picture_source_test
{
namespace
{

constexpr int kMotionJpeg = 6; ///< grey levels that compression changes

GreyPicture plain(std::uint8_t grey)
{
    return {64, 48, std::vector<std::uint8_t>(std::size_t{64} * 48, grey)};
}

std::filesystem::path pathIn(const QTemporaryDir& folder, const char* name)
{
    return folder.filePath(QString::fromLatin1(name)).toStdString();
}

} // namespace

class TestPictureSource : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesTheFilesOfAFolderByTheirNames()
    {
        const QTemporaryDir folder;
        QVERIFY(writePicture(pathIn(folder, "b.png"), plain(20)));
        QVERIFY(writePicture(pathIn(folder, "a.png"), plain(10)));
        QVERIFY(writePicture(pathIn(folder, "c.PNG"), plain(30)));
        std::ofstream{pathIn(folder, "notes.txt")} << "no picture";
        auto source = PictureSource::open({.kind = kindOfPlace(folder.path().toStdString()),
                                           .path = folder.path().toStdString(),
                                           .rate = 10.0});
        QVERIFY(source);
        for (int i = 0; i < 3; ++i) {
            const auto taken = source->next();
            QVERIFY(taken);
            QCOMPARE(int(taken->picture.at(5, 5)), 10 * (i + 1));
            QCOMPARE(taken->time, Duration{std::chrono::milliseconds{100 * i}});
            QVERIFY(!taken->stamped);
        }
        QVERIFY(!source->next());
        QVERIFY(!source->skip());
    }

    void passesOverADamagedFile()
    {
        const QTemporaryDir folder;
        std::ofstream{pathIn(folder, "a.png")} << "no picture";
        QVERIFY(writePicture(pathIn(folder, "b.png"), plain(20)));
        auto source = PictureSource::open(
            {.kind = PicturePlace::Kind::Folder, .path = folder.path().toStdString()});
        QVERIFY(source);
        const auto taken = source->next();
        QVERIFY(taken);
        QCOMPARE(int(taken->picture.at(5, 5)), 20);
    }

    void playsAVideo()
    {
        const QTemporaryDir folder;
        const auto file = pathIn(folder, "markers.avi");
        {
            auto video = VideoWriter::open(file, 25.0, 64, 48);
            QVERIFY(video);
            for (int i = 0; i < 5; ++i)
                QVERIFY(video->add(plain(std::uint8_t(40 * i))));
            QVERIFY(!video->add({32, 32, std::vector<std::uint8_t>(std::size_t{32} * 32)}));
        }
        QCOMPARE(kindOfPlace(file), PicturePlace::Kind::Video);
        auto source = PictureSource::open({.kind = PicturePlace::Kind::Video, .path = file});
        QVERIFY(source);
        QCOMPARE(source->rate(), 25.0);
        QVERIFY(source->skip());
        for (int i = 1; i < 5; ++i) {
            const auto taken = source->next();
            QVERIFY(taken);
            const int grey = taken->picture.at(30, 20);
            QVERIFY2(std::abs(grey - 40 * i) < kMotionJpeg, qPrintable(QString::number(grey)));
            QCOMPARE(taken->time, Duration{std::chrono::milliseconds{40 * i}});
        }
        QVERIFY(!source->next());
    }

    void saysWhatIsNotThere_data()
    {
        QTest::addColumn<PicturePlace::Kind>("kind");
        QTest::addColumn<QString>("name");
        QTest::addColumn<Errc>("code");
        QTest::newRow("no video") << PicturePlace::Kind::Video << QStringLiteral("none.avi")
                                  << Errc::FileNotFound;
        QTest::newRow("no folder")
            << PicturePlace::Kind::Folder << QStringLiteral("none") << Errc::FileNotFound;
        QTest::newRow("a folder without pictures")
            << PicturePlace::Kind::Folder << QStringLiteral(".") << Errc::NothingRecognised;
        QTest::newRow("a text") << PicturePlace::Kind::Video << QStringLiteral("notes.txt")
                                << Errc::UnknownFormat;
        QTest::newRow("no camera")
            << PicturePlace::Kind::Camera << QStringLiteral("video0") << Errc::TrackerFailed;
    }

    void saysWhatIsNotThere()
    {
        QFETCH(const PicturePlace::Kind, kind);
        QFETCH(const QString, name);
        QFETCH(const Errc, code);
        const QTemporaryDir folder;
        std::ofstream{pathIn(folder, "notes.txt")} << "no video";
        const auto source =
            PictureSource::open({.kind = kind, .path = folder.filePath(name).toStdString()});
        QVERIFY(!source);
        QCOMPARE(source.error().code, code);
        QVERIFY(source.error().detail.find(folder.path().toStdString()) == 0);
    }

    void knowsACameraByItsPath()
    {
        QCOMPARE(kindOfPlace("/dev/video0"), PicturePlace::Kind::Camera);
        QCOMPARE(kindOfPlace("/dev"), PicturePlace::Kind::Folder);
        QCOMPARE(kindOfPlace("/tmp"), PicturePlace::Kind::Folder);
        QCOMPARE(kindOfPlace("/tmp/none.avi"), PicturePlace::Kind::Video);
    }
};

CARINA_TEST(TestPictureSource)

} // namespace carina::picture_source_test

#include "tst_picture_source.moc"
