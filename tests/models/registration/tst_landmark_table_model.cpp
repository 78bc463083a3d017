#include "models/registration/landmark_table_model.h"
#include "tests/models/registration/registration_site.h"
#include "tests/support/test_class.h"

#include <QAbstractItemModelTester>
#include <QFont>
#include <QSignalSpy>

namespace carina::landmark_table_model_test
{

class TestLandmarkTableModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void namesItsColumns();
    void showsHowFarTheTouchingHasCome();
    void showsResidualsOnceTheyAreKnown();
    void showsHowFarALandmarkLiesFromTheOthers();
    void marksTouchesThatAreStale();
    void speaksEachCell();
    void explainsItsNumbers();
    void changesCellsWithoutLosingTheSelection();
};

namespace
{

using Column = LandmarkTableModel::Column;

/// Of the four landmarks on the rib cage.
struct Table {
    RegistrationSite site;
    std::unique_ptr<RegistrationModel> registration = site.model();
    LandmarkTableModel model{*registration};
    QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::QtTest};

    Table() { registration->landmarkTask().chooseSet(2); }

    [[nodiscard]] QVariant at(int row, int column, int role = Qt::DisplayRole) const
    {
        return model.data(model.index(row, column), role);
    }
    [[nodiscard]] QString cell(int row, int column) const { return at(row, column).toString(); }

    void touch(std::size_t landmark, const Vec3& off_A = Vec3::Zero())
    {
        site.hold(*registration, site.X_TA * Vec3{site.sets()[2].landmarks[landmark].p_AQ + off_A});
    }
    void touchTheFirst()
    {
        site.prepare(*registration);
        touch(0);
    }
};

} // namespace

void TestLandmarkTableModel::namesItsColumns()
{
    const Table table;
    QStringList headers;
    for (int column = 0; column < table.model.columnCount(); ++column)
        headers << table.model.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    QCOMPARE(headers, (QStringList{QStringLiteral("Landmark"), QStringLiteral("Touched"),
                                   QStringLiteral("Residual"), QStringLiteral("Left out")}));
}

void TestLandmarkTableModel::showsHowFarTheTouchingHasCome()
{
    Table table;
    QCOMPARE(table.model.rowCount(), 4);
    QCOMPARE(table.cell(0, Column::Name), QStringLiteral("Sternal notch"));
    QCOMPARE(table.cell(0, Column::Touched), QStringLiteral("○ open"));
    table.touchTheFirst();
    QCOMPARE(table.cell(0, Column::Touched), QStringLiteral("✓ ±0.0 mm")); // its samples are exact
    QCOMPARE(table.cell(1, Column::Touched), QStringLiteral("● now"));
    QCOMPARE(table.cell(2, Column::Touched), QStringLiteral("○ open"));
    QVERIFY(table.at(1, Column::Name, Qt::FontRole).value<QFont>().bold());
    QVERIFY(!table.at(0, Column::Name, Qt::FontRole).isValid());
}

void TestLandmarkTableModel::showsResidualsOnceTheyAreKnown()
{
    Table table;
    table.touchTheFirst();
    QCOMPARE(table.cell(0, Column::Residual), QStringLiteral("–"));
    QVERIFY(!table.at(0, Column::Residual, LandmarkTableModel::kValueRole).isValid());
    QCOMPARE(table.model.largestResidual_mm(), 0.0);
    // The two ribs are touched 6 mm too far from each other. The triangle of the others holds the
    // rest: by symmetry each rib stays at most 3 mm from its place.
    const auto landmarks = table.site.landmarks();
    const Vec3 outward = (landmarks[2].p_AQ - landmarks[3].p_AQ).normalized();
    table.touch(1);
    table.touch(2, 0.003 * outward);
    table.touch(3, -0.003 * outward);
    table.registration->fitting().fit();
    const double left = table.at(2, Column::Residual, LandmarkTableModel::kValueRole).toDouble();
    const double right = table.at(3, Column::Residual, LandmarkTableModel::kValueRole).toDouble();
    QVERIFY(std::abs(left - 3.0) < 1e-3); // mm
    QVERIFY(std::abs(right - 3.0) < 1e-3);
    QCOMPARE(table.cell(2, Column::Residual), QStringLiteral("3.0 mm"));
    QCOMPARE(table.model.largestResidual_mm(), std::max(left, right));
}

/// All others are exact: it lies as far from where they put it as it was touched off its place.
void TestLandmarkTableModel::showsHowFarALandmarkLiesFromTheOthers()
{
    Table table;
    table.touchTheFirst();
    table.touch(1);
    table.touch(2);
    table.touch(3, {0.0, 0.004, 0.0});
    QCOMPARE(table.cell(3, Column::LeftOut), QStringLiteral("–"));
    table.registration->fitting().fit();
    QCOMPARE(table.cell(3, Column::LeftOut), QStringLiteral("4.0 mm"));
}

void TestLandmarkTableModel::marksTouchesThatAreStale()
{
    Table table;
    table.touchTheFirst();
    table.registration->enter(SiteStep::Stylus);
    table.registration->stylus().findTip();
    table.site.swing(*table.registration);
    QCOMPARE(table.cell(0, Column::Touched), QStringLiteral("▲ redo"));
    QCOMPARE(table.at(0, Column::Touched, Qt::AccessibleTextRole).toString(),
             QStringLiteral("Touched: redo"));
}

void TestLandmarkTableModel::speaksEachCell()
{
    Table table;
    table.touchTheFirst();
    const auto spoken = [&](int row, int column) {
        return table.at(row, column, Qt::AccessibleTextRole).toString();
    };
    QCOMPARE(spoken(1, Column::Name), QStringLiteral("Landmark: Xiphoid process"));
    QCOMPARE(spoken(1, Column::Touched), QStringLiteral("Touched: now"));
    QCOMPARE(spoken(1, Column::Residual), QStringLiteral("Residual: unknown"));
}

void TestLandmarkTableModel::explainsItsNumbers()
{
    const Table table;
    for (const int role : {Qt::ToolTipRole, Qt::WhatsThisRole, Qt::AccessibleDescriptionRole})
        for (const int column : {Column::Touched, Column::Residual, Column::LeftOut})
            QVERIFY(!table.model.headerData(column, Qt::Horizontal, role).toString().isEmpty());
}

void TestLandmarkTableModel::changesCellsWithoutLosingTheSelection()
{
    Table table;
    const QPersistentModelIndex selected = table.model.index(2, Column::Name);
    QSignalSpy changes{&table.model, &QAbstractItemModel::dataChanged};
    table.touchTheFirst();
    QVERIFY(changes.count() > 0);
    QVERIFY(selected.isValid());
    QCOMPARE(selected.row(), 2);
}

CARINA_SCREEN_TEST(TestLandmarkTableModel)

} // namespace carina::landmark_table_model_test

#include "tst_landmark_table_model.moc"
