#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

namespace carina::registration_test
{

namespace
{

} // namespace

/// The wizard, worked by a scripted technician and killed without warning on every page.
class TestRegistration : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void standsWhereItStoodWhenItWasKilled()
    {
        QTemporaryDir folder;
        QVERIFY(folder.isValid());
        Program technician{QStringLiteral(CARINA_REGISTRATION),
                           {QStringLiteral("--tracker"), QStringLiteral("simulated"),
                            QStringLiteral("--patient"), QStringLiteral("child"),
                            QStringLiteral("--site"), folder.filePath(QStringLiteral("site.json")),
                            QStringLiteral("--measure"), folder.filePath(QStringLiteral("out"))},
                           folder.filePath(QStringLiteral("technician.jsonl"))};
        QJsonObject last;
        for (const char* step :
             {"tracker", "stylus", "landmarks", "touch", "fit", "verify", "tools", "overview"}) {
            technician.start();
            QTRY_VERIFY_WITH_TIMEOUT(isAt(technician.shown(), QLatin1String{step}), kPatience_ms);
            if (!last.isEmpty())
                QCOMPARE(technician.shownFirst(), last);
            technician.kill();
            last = technicianShowed(folder);
        }
        technician.start();
        QTRY_VERIFY_WITH_TIMEOUT(technician.hasEnded(), kPatience_ms);
        QCOMPARE(technician.shownFirst(), last);
        QCOMPARE(technician.exitCode(), 0);
    }

private:
    /// In the middle of what that page is for, where there is a middle.
    static bool isAt(const QJsonObject& shown, QLatin1String step)
    {
        if (shown[QStringLiteral("step")].toString() != step)
            return false;
        if (step == QLatin1String{"touch"})
            return shown[QStringLiteral("touched")].toInt() == 3;
        return step != QLatin1String{"verify"} || shown[QStringLiteral("checked")].toInt() == 1;
    }

    /// The last whole line of the technician's journal, whichever run wrote it.
    static QJsonObject technicianShowed(const QTemporaryDir& folder)
    {
        QFile file{folder.filePath(QStringLiteral("technician.jsonl"))};
        if (!file.open(QIODevice::ReadOnly))
            return {};
        const QByteArrayList lines = file.readAll().split('\n');
        return QJsonDocument::fromJson(lines.value(lines.size() - 2)).object();
    }
};

CARINA_TEST(TestRegistration)

} // namespace carina::registration_test

#include "tst_registration.moc"
