#include "tests/support/test_class.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

namespace carina::attacks_test
{

/// What one who knows a code can do to a console and a trainee. The bounds are those of
/// `carina-lab attack`.
class TestAttacks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sessionHolds_data()
    {
        QTest::addColumn<QString>("attack");
        for (const char* attack :
             {"leaving",       "sharing", "breathing",  "repeating",   "impostor", "false-token",
              "client-hellos", "paths",   "false-tube", "shown",       "crowd",    "strangers",
              "actions",       "names",   "garbage",    "instructing", "messages", "steady",
              "turns",         "hungry",  "together",   "new-codes",   "gallery"})
            QTest::newRow(attack) << QString::fromLatin1(attack);
    }

    void sessionHolds()
    {
        QFETCH(QString, attack);
        const QJsonObject figures = attacked({QStringLiteral("--only"), attack});
        const QJsonArray attacks = figures[QLatin1StringView{"attacks"}].toArray();
        QCOMPARE(attacks.size(), qsizetype{1});
        const QJsonObject figure = attacks.first().toObject();
        QVERIFY2(figure[QLatin1StringView{"holds"}].toBool(),
                 QJsonDocument{figure}.toJson().constData());
        QVERIFY(figures[QLatin1StringView{"acceptable"}].toBool());
    }

    /// 256 programs, of which eighteen are hostile.
    void sessionOf256Holds()
    {
        const QJsonObject figures = attacked({QStringLiteral("--only"), QStringLiteral("together"),
                                              QStringLiteral("--guests"), QStringLiteral("235")});
        const QJsonObject figure =
            figures[QLatin1StringView{"attacks"}].toArray().first().toObject();
        const QByteArray said = QJsonDocument{figure}.toJson();
        qInfo("%s", said.constData()); // the gap above all
        QVERIFY2(figure[QLatin1StringView{"holds"}].toBool(), said.constData());
        QCOMPARE(figure[QLatin1StringView{"put_out"}].toInt(-1), 0);
    }

    /// No program ends, and the last of them finds as whole a session as the first.
    void sessionHoldsThroughAllOfThem()
    {
        const QJsonObject figures = attacked({});
        const QJsonArray attacks = figures[QLatin1StringView{"attacks"}].toArray();
        QVERIFY(!attacks.isEmpty());
        for (const auto& each : attacks)
            QVERIFY2(each[QLatin1StringView{"holds"}].toBool(),
                     QJsonDocument{each.toObject()}.toJson().constData());
        QVERIFY(figures[QLatin1StringView{"acceptable"}].toBool());
    }

private:
    static constexpr int kPatience_ms = 1'500'000;

    /// What carina-lab printed; nothing where it could not print.
    static QJsonObject attacked(const QStringList& more)
    {
        QProcess lab;
        lab.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        lab.start(
            QStringLiteral(CARINA_LAB),
            QStringList{QStringLiteral("attack"), QStringLiteral("--seconds"), QStringLiteral("5")}
                + more);
        if (!lab.waitForFinished(kPatience_ms))
            return {};
        return QJsonDocument::fromJson(lab.readAllStandardOutput()).object();
    }
};

CARINA_SCREEN_TEST(TestAttacks)

} // namespace carina::attacks_test

#include "tst_attacks.moc"
