#pragma once

#include "models/registration/registration_model.h"

#include <QAbstractTableModel>

#include <vector>

namespace carina
{

/// The landmarks of a registration: which, how still the stylus was when it touched them, how far
/// they stay from their places after the fit, and how far from where all others put them.
class LandmarkTableModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Name, Touched, Residual, LeftOut, ColumnCount };
    static constexpr int kValueRole = Qt::UserRole; ///< a residual as a number, in millimetres

    /// @pre registration outlives this.
    explicit LandmarkTableModel(const RegistrationModel& registration, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role) const override;

    /// What the numbers of a column are; empty where its name says it.
    [[nodiscard]] static QString explanation(int column);

    [[nodiscard]] int touchedCount() const;
    /// The largest residual, in millimetres; 0 without any.
    [[nodiscard]] double largestResidual_mm() const;

private:
    void refresh();
    [[nodiscard]] static QString cell(const LandmarkRow& row, int column);
    /// A cell as a screen reader says it: with its column, and without a shape.
    [[nodiscard]] QString spoken(const LandmarkRow& row, int column) const;

    const RegistrationModel& m_registration;
    std::vector<LandmarkRow> m_rows;
};

} // namespace carina
