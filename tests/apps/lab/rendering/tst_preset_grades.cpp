#include "apps/lab/commands.h"
#include "tests/support/test_class.h"
#include "widgets/scene/view/graphics.h"

#include <QJsonArray>
#include <QJsonObject>

namespace carina::preset_grades_test
{
namespace
{

constexpr int kDraws = 10;
constexpr double kNineOfTen = 0.9;

/// Of the adult.
QJsonObject counted(const QStringList& more)
{
    const auto object =
        lab::renderCommand().run(QStringList{QStringLiteral("--preset-grades"),
                                             QStringLiteral("--size"), QStringLiteral("320x240")}
                                 + more);
    if (!object)
        qWarning("%s", object.error().detail.c_str());
    return object.value_or(QJsonObject{});
}

} // namespace

class TestPresetGrades : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void initTestCase();
    void init();
    void countsEveryDraw();
    void givesTheNamedGrade_data();
    void givesTheNamedGrade();
    void drawsAlikeFromTheSameSeed();
    void saysWhetherAllAreRight();

private:
    QJsonObject m_counted;
};

void TestPresetGrades::initTestCase()
{
    if (graphicsDriver())
        m_counted = counted({QStringLiteral("--draws"), QString::number(kDraws)});
}

void TestPresetGrades::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
}

void TestPresetGrades::countsEveryDraw()
{
    const QJsonArray presets = m_counted[QStringLiteral("presets")].toArray();
    QCOMPARE(presets.size(), 4);
    for (const QJsonValue preset : presets) {
        QCOMPARE(preset[QStringLiteral("draws")].toInt(), kDraws);
        int all = 0;
        for (const QJsonValue count : preset[QStringLiteral("grades")].toObject())
            all += count.toInt();
        QCOMPARE(all, kDraws);
        for (const QJsonValue range : preset[QStringLiteral("ranges")].toArray())
            QVERIFY(!range[QStringLiteral("source")].toString().isEmpty());
    }
}

void TestPresetGrades::givesTheNamedGrade_data()
{
    QTest::addColumn<int>("grade");
    for (const int grade : {1, 2, 3, 4})
        QTest::newRow(qPrintable(QString::number(grade))) << grade;
}

void TestPresetGrades::givesTheNamedGrade()
{
    QFETCH(const int, grade);
    const QJsonValue preset = m_counted[QStringLiteral("presets")].toArray()[grade - 1];
    QCOMPARE(preset[QStringLiteral("named_grade")].toInt(), grade);
    const QJsonObject grades = preset[QStringLiteral("grades")].toObject();
    int right = 0;
    QStringList seen;
    for (auto count = grades.begin(); count != grades.end(); ++count) {
        right += count.key().startsWith(QString::number(grade)) ? count->toInt() : 0;
        seen += QStringLiteral("%1: %2").arg(count.key()).arg(count->toInt());
    }
    QCOMPARE(preset[QStringLiteral("share_right")].toDouble(), double(right) / kDraws);
    QVERIFY2(right >= kNineOfTen * kDraws, qPrintable(seen.join(QStringLiteral(", "))));
}

void TestPresetGrades::drawsAlikeFromTheSameSeed()
{
    const QStringList few{QStringLiteral("--draws"), QStringLiteral("2"), QStringLiteral("--seed"),
                          QStringLiteral("5")};
    const QJsonObject once = counted(few);
    QCOMPARE(once[QStringLiteral("seed")].toInt(), 5);
    QCOMPARE(once, counted(few));
}

void TestPresetGrades::saysWhetherAllAreRight()
{
    bool isRight = true;
    for (const QJsonValue preset : m_counted[QStringLiteral("presets")].toArray())
        isRight = isRight && preset[QStringLiteral("share_right")].toDouble() >= kNineOfTen;
    QCOMPARE(m_counted[QStringLiteral("acceptable")].toBool(), isRight);
}

CARINA_SCREEN_TEST(TestPresetGrades)

} // namespace carina::preset_grades_test

#include "tst_preset_grades.moc"
