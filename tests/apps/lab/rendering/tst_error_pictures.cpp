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

/// Into a folder, of the built-in child, for this many landmarks and that error of a touch.
QJsonObject drawn(const QString& folder, const char* landmarks, const char* fle_mm)
{
    const auto object = lab::renderCommand().run(
        {QStringLiteral("--error-map"), folder, QStringLiteral("--size"), QStringLiteral("320x200"),
         QStringLiteral("--landmarks"), QString::fromLatin1(landmarks), QStringLiteral("--fle"),
         QString::fromLatin1(fle_mm)});
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
    void initTestCase();
    void init();
    void drawsFourSides();
    void growsWithTheErrorOfATouch();
    void shrinksWithMoreLandmarks();
    void refusesWhatIsNoRegistration_data();
    void refusesWhatIsNoRegistration();

private:
    QTemporaryDir m_folder;
    QJsonObject m_usual; ///< four landmarks, 1 mm
};

void TestErrorPictures::initTestCase()
{
    if (graphicsDriver())
        m_usual = drawn(m_folder.filePath(QStringLiteral("usual")), "4", "1");
}

void TestErrorPictures::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
}

void TestErrorPictures::drawsFourSides()
{
    const QJsonArray pictures = m_usual[QStringLiteral("pictures")].toArray();
    QCOMPARE(pictures.size(), 4);
    QList<QImage> different;
    for (const QJsonValue picture : pictures) {
        const QImage image{m_folder.filePath(QStringLiteral("usual/")
                                             + picture[QStringLiteral("file")].toString())};
        QCOMPARE(image.size(), kSize);
        QVERIFY(!different.contains(image));
        different += image;
    }
}

void TestErrorPictures::growsWithTheErrorOfATouch()
{
    const QJsonObject three = drawn(m_folder.filePath(QStringLiteral("three")), "4", "3");
    QVERIFY(figure(m_usual, "least_rms_mm") >= 0.5); // FLE / sqrt(4), at the landmarks' centroid
    QVERIFY(figure(m_usual, "most_rms_mm") > figure(m_usual, "least_rms_mm"));
    for (const char* name : {"least_rms_mm", "most_rms_mm"})
        QVERIFY(std::abs(figure(three, name) - 3.0 * figure(m_usual, name)) < 1e-9);
    QVERIFY(figure(three, "band_mm") > figure(m_usual, "band_mm"));
}

void TestErrorPictures::shrinksWithMoreLandmarks()
{
    const QJsonObject eight = drawn(m_folder.filePath(QStringLiteral("eight")), "8", "1");
    for (const char* name : {"least_rms_mm", "most_rms_mm"})
        QVERIFY(figure(eight, name) < figure(m_usual, name));
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
    QCOMPARE(object.error().code, Errc::WrongOption);
}

CARINA_SCREEN_TEST(TestErrorPictures)

} // namespace carina::error_pictures_test

#include "tst_error_pictures.moc"
