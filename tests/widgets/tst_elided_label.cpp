#include "tests/support/test_class.h"
#include "widgets/elided_label.h"

#include <QImage>

namespace carina::elided_label_test
{

class TestElidedLabel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void leavesOutTheEndOfWhatIsTooLong();
    void keepsItsLineWithoutText();
    void asksForNoWidth();
    void drawsWhatThereIsRoomFor();
};

namespace
{

const QString kLong = QStringLiteral("Tom is at work already, and shares no head.");

} // namespace

void TestElidedLabel::leavesOutTheEndOfWhatIsTooLong()
{
    ElidedLabel label;
    label.setText(kLong);
    label.resize(label.sizeHint());
    QCOMPARE(label.shownText(), kLong);
    label.resize(label.width() / 2, label.height());
    QVERIFY(label.shownText().startsWith(QStringLiteral("Tom is")));
    QVERIFY(label.shownText().size() < kLong.size());
    QVERIFY(label.fontMetrics().horizontalAdvance(label.shownText()) <= label.width());
    QCOMPARE(label.text(), kLong);
}

void TestElidedLabel::keepsItsLineWithoutText()
{
    ElidedLabel label;
    const int empty = label.sizeHint().height();
    QVERIFY(empty >= label.fontMetrics().height());
    label.setText(kLong);
    QCOMPARE(label.sizeHint().height(), empty);
    QVERIFY(!label.hasHeightForWidth());
}

void TestElidedLabel::asksForNoWidth()
{
    ElidedLabel label;
    label.setText(kLong);
    QCOMPARE(label.minimumSizeHint().width(), 0);
    QCOMPARE(label.sizePolicy().horizontalPolicy(), QSizePolicy::Ignored);
}

/// A text that is cut looks as what is left of it does.
void TestElidedLabel::drawsWhatThereIsRoomFor()
{
    ElidedLabel cut;
    cut.setText(kLong);
    cut.resize(cut.sizeHint().width() / 2, cut.sizeHint().height());
    ElidedLabel left;
    left.setText(cut.shownText());
    left.resize(cut.size());
    const QImage picture = cut.grab().toImage();
    QCOMPARE(picture, left.grab().toImage());
    ElidedLabel empty;
    empty.resize(cut.size());
    QVERIFY(picture != empty.grab().toImage());
}

CARINA_SCREEN_TEST(TestElidedLabel)

} // namespace carina::elided_label_test

#include "tst_elided_label.moc"
