#include "apps/lab/commands.h"
#include "tests/support/test_class.h"
#include "widgets/scene/view/graphics.h"

#include <QImage>
#include <QJsonArray>
#include <QJsonObject>
#include <QTemporaryDir>

#include <cmath>

namespace carina::error_pictures_test
{

namespace
{

constexpr QSize kSize{320, 200};

/// Of the built-in child, for this many landmarks and that error of a touch.
QJsonObject drawn(const QTemporaryDir& folder, const char* landmarks, const char* fle_mm)
{
    const auto object = lab::renderCommand().run(
        {QStringLiteral("--error-map"), folder.filePath(QStringLiteral("new")),
         QStringLiteral("--size"), QStringLiteral("320x200"), QStringLiteral("--landmarks"),
         QString::fromLatin1(landmarks), QStringLiteral("--fle"), QString::fromLatin1(fle_mm)});
    return object.value_or(QJsonObject{});
}

double figure(const QJsonObject& object, const char* name)
{
    return object[QLatin1StringView{name}].toDouble();
}

} // namespace

class TestErrorPictures : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void init();
    void drawsFourSides();
    void growsWithTheErrorOfATouch();
    void shrinksWithMoreLandmarks();
    void refusesWhatIsNoRegistration_data();
    void refusesWhatIsNoRegistration();
};

void TestErrorPictures::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
}

void TestErrorPictures::drawsFourSides()
{
    const QTemporaryDir folder;
    const QJsonObject object = drawn(folder, "4", "1");
    const QJsonArray pictures = object[QStringLiteral("pictures")].toArray();
    QCOMPARE(pictures.size(), 4);
    QList<QImage> different;
    for (const QJsonValue picture : pictures) {
        const QImage image{
            folder.filePath(QStringLiteral("new/") + picture[QStringLiteral("file")].toString())};
        QCOMPARE(image.size(), kSize);
        QVERIFY(!different.contains(image));
        different += image;
    }
}

void TestErrorPictures::growsWithTheErrorOfATouch()
{
    const QTemporaryDir folder;
    const QJsonObject one = drawn(folder, "4", "1");
    const QJsonObject three = drawn(folder, "4", "3");
    QVERIFY(figure(one, "least_rms_mm") >= 0.5); // FLE / sqrt(4), at the landmarks' centroid
    QVERIFY(figure(one, "most_rms_mm") > figure(one, "least_rms_mm"));
    for (const char* name : {"least_rms_mm", "most_rms_mm"})
        QVERIFY(std::abs(figure(three, name) - 3.0 * figure(one, name)) < 1e-9);
    QVERIFY(figure(three, "band_mm") > figure(one, "band_mm"));
}

void TestErrorPictures::shrinksWithMoreLandmarks()
{
    const QTemporaryDir folder;
    const QJsonObject four = drawn(folder, "4", "1");
    const QJsonObject eight = drawn(folder, "8", "1");
    for (const char* name : {"least_rms_mm", "most_rms_mm"})
        QVERIFY(figure(eight, name) < figure(four, name));
}

void TestErrorPictures::refusesWhatIsNoRegistration_data()
{
    QTest::addColumn<QString>("option");
    QTest::addColumn<QString>("value");
    QTest::newRow("two landmarks") << QStringLiteral("--landmarks") << QStringLiteral("2");
    QTest::newRow("nine landmarks") << QStringLiteral("--landmarks") << QStringLiteral("9");
    QTest::newRow("no error of a touch") << QStringLiteral("--fle") << QStringLiteral("0");
    QTest::newRow("no number") << QStringLiteral("--fle") << QStringLiteral("much");
    QTest::newRow("a breath") << QStringLiteral("--condition") << QStringLiteral("copd");
}

void TestErrorPictures::refusesWhatIsNoRegistration()
{
    QFETCH(const QString, option);
    QFETCH(const QString, value);
    const QTemporaryDir folder;
    const auto object =
        lab::renderCommand().run({QStringLiteral("--error-map"), folder.path(), option, value});
    QVERIFY(!object.has_value());
    QCOMPARE(object.error().code, Errc::OutOfRange);
}

CARINA_SCREEN_TEST(TestErrorPictures)

} // namespace carina::error_pictures_test

#include "tst_error_pictures.moc"
