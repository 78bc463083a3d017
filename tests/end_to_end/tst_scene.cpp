#include "evaluation/scene/drawn_scene.h"
#include "tests/support/test_class.h"

#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

namespace carina::scene_test
{

namespace
{

constexpr int kScenePatience_ms = 500'000; ///< for seven programs to come in on a busy machine
constexpr int kEveryone = 7;
/// Each console and trainee has to draw head, hand and tube of all trainees at its station but the
/// own: the console at one station 9, six trainees 6 each.
constexpr int kSeen = 45;

} // namespace

/// carina-lab scene: two stations with three trainees each, one of whom is 40 ms away.
class TestScene : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        QProcess lab;
        lab.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        lab.start(QStringLiteral(CARINA_LAB),
                  {QStringLiteral("scene"), QStringLiteral("--seconds"), QStringLiteral("20"),
                   QStringLiteral("--size"), QStringLiteral("1280x800"), QStringLiteral("--out"),
                   m_folder.path()});
        QVERIFY(lab.waitForFinished(kScenePatience_ms));
        m_figures = QJsonDocument::fromJson(lab.readAllStandardOutput()).object();
        QVERIFY(!m_figures.isEmpty());
        m_exitCode = lab.exitCode();
    }

    void everybodyIsDrawnWhereTheyAre()
    {
        QCOMPARE(m_figures[QLatin1StringView{"seen"}].toInt(), kSeen);
        QCOMPARE(m_figures[QLatin1StringView{"owner_changes"}].toInt(), 0);
        QCOMPARE(m_figures[QLatin1StringView{"mistaken"}].toInt(), 0);
        QVERIFY(m_figures[QLatin1StringView{"recognisable"}].toInt() > 300);
        for (const char* which : {"near", "far"})
            QVERIFY(m_figures[QLatin1StringView{which}]
                        .toObject()[QLatin1StringView{"compared"}]
                        .toInt()
                    > 300);
        // Of the path that it has unless another is named.
        const QJsonObject far = m_figures[QLatin1StringView{"far"}].toObject();
        const auto isBelow = [&far](const char* key, double bound) {
            return far[QLatin1StringView{key}].toDouble() <= bound;
        };
        QVERIFY(isBelow("median_mm", inMillimetres(kBoundsOfRemote.median.position)));
        QVERIFY(isBelow("median_deg", inDegrees(kBoundsOfRemote.median.rotation)));
        QVERIFY(isBelow("p95_mm", inMillimetres(kBoundsOfRemote.p95.position)));
        QVERIFY(isBelow("p95_deg", inDegrees(kBoundsOfRemote.p95.rotation)));
        QCOMPARE(m_figures[QLatin1StringView{"acceptable"}], QJsonValue{true});
        QCOMPARE(m_exitCode, 0);
    }

    void everyWindowHasAPicture()
    {
        const QJsonArray programs = m_figures[QLatin1StringView{"programs"}].toArray();
        QCOMPARE(programs.size(), kEveryone);
        for (const QJsonValue& program : programs) {
            const QString name = program.toObject()[QLatin1StringView{"name"}].toString().toLower();
            const QImage picture{m_folder.filePath(name + QStringLiteral(".png"))};
            QVERIFY2(picture.size() == QSize(1280, 800), qPrintable(name));
        }
    }

private:
    QTemporaryDir m_folder;
    QJsonObject m_figures;
    int m_exitCode = -1;
};

CARINA_TEST(TestScene)

} // namespace carina::scene_test

#include "tst_scene.moc"
