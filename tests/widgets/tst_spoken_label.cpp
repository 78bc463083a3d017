#include "tests/support/test_class.h"
#include "widgets/plain_label.h"
#include "widgets/spoken_label.h"

#include <QAccessible>

namespace carina::spoken_label_test
{
namespace
{

QString spokenOf(QLabel& label)
{
    return QAccessible::queryAccessibleInterface(&label)->text(QAccessible::Name);
}

} // namespace

class TestSpokenLabel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { installSpokenLabels(); }

    void saysNameAndText()
    {
        PlainLabel label{QStringLiteral("7K3QM-XW2PD")};
        label.setAccessibleName(QStringLiteral("Code for trainees"));
        QCOMPARE(spokenOf(label), QStringLiteral("Code for trainees: 7K3QM-XW2PD"));
        label.setText(QStringLiteral("AAAAA-BBBBB"));
        QCOMPARE(spokenOf(label), QStringLiteral("Code for trainees: AAAAA-BBBBB"));
        label.clear();
        QCOMPARE(spokenOf(label), QStringLiteral("Code for trainees"));
    }

    void saysTheTextOfALabelWithoutAName()
    {
        PlainLabel label{QStringLiteral("Paused")};
        QCOMPARE(spokenOf(label), QStringLiteral("Paused"));
    }

    void saysWhatALabelOfAFieldShows()
    {
        QLabel field;
        PlainLabel label{QStringLiteral("Ne&xt && last")};
        label.setBuddy(&field);
        QCOMPARE(spokenOf(label), QStringLiteral("Next & last"));
    }

    void saysOtherWordsInsteadWhereThereAre()
    {
        PlainLabel label{QStringLiteral("▲ Tom is aw…")};
        speakInstead(label, QStringLiteral("Tom is away"));
        QCOMPARE(spokenOf(label), QStringLiteral("Tom is away"));
    }
};

CARINA_SCREEN_TEST(TestSpokenLabel)

} // namespace carina::spoken_label_test

#include "tst_spoken_label.moc"
