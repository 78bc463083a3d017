#pragma once

#include "models/registration/registration_model.h"

#include <QAbstractTableModel>

#include <vector>

namespace carina
{

/// The landmarks of a registration as a table: name, spread of the stylus tip during the touch,
/// residual after the fit (FRE of that landmark), and distance from the fit of all other landmarks
/// (leave-one-out).
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

    /// A sentence that explains the numbers of a column; empty if its name is enough.
    [[nodiscard]] static QString explanation(int column);

    /// The largest residual, in millimetres; 0 without any.
    [[nodiscard]] double largestResidual_mm() const;

private:
    void refresh();
    [[nodiscard]] static QString cell(const LandmarkRow& row, int column);
    /// The text of a cell for a screen reader: with its column name, without the state mark.
    [[nodiscard]] QString spoken(const LandmarkRow& row, int column) const;

    const RegistrationModel& m_registration;
    std::vector<LandmarkRow> m_rows;
};

} // namespace carina
