#include "sim/logs/import_settings.h"

#include "sim/core/units.h"
#include "sim/io/csv_cells.h"

namespace rotorbench {

char separatorSign(Separator separator) {
  switch (separator) {
    case Separator::Comma:
      return ',';
    case Separator::Semicolon:
      return ';';
    case Separator::Tab:
      return '\t';
    case Separator::Spaces:
      return kSpaces;
    case Separator::Bar:
      return '|';
  }
  return ',';
}

Channel channelOf(const ColumnMapping& column, ChannelGroup group) {
  if (const Quantity* quantity = findQuantity(column.quantity)) {
    return {channelName(*quantity, group), std::string(quantity->unit),
            std::string(quantity->label) + ", measured"};
  }
  const Unit* unit = findUnit(column.unit);
  const std::string si =
      unit != nullptr ? std::string(unit->dimension) : canonicalUnit(column.unit);
  return {column.channel.empty() ? column.column : column.channel, si, "Measured"};
}

UnitConversion conversionOf(const ColumnMapping& column) {
  if (const Quantity* quantity = findQuantity(column.quantity)) {
    return conversionOf(*quantity, column.unit).value_or(UnitConversion{});
  }
  const Unit* unit = findUnit(column.unit);
  return {unit != nullptr ? unit->factor : 1, 0};
}

std::string columnsKey(const CsvPreview& preview) {
  std::string key;
  for (const PreviewColumn& column : preview.columns) {
    key += column.name + " [" + column.unit + "]\n";
  }
  return key;
}

ChannelGroup guessGroup(const std::vector<ColumnMapping>& columns) {
  for (const auto group :
       {ChannelGroup::Run, ChannelGroup::OverThrottle, ChannelGroup::OverAdvance}) {
    for (const ColumnMapping& column : columns) {
      if (column.quantity == abscissaOf(group).key) return group;
    }
  }
  return ChannelGroup::Run;
}

void Describe<CsvLayout>::fields(schema::Builder<CsvLayout>& b) {
  using L = CsvLayout;
  b.title("layout", "Layout", "Where the cells of a table of text begin and end.");
  b.choice("separator", &L::separator, "Separator",
           {schema::Named<Separator>{Separator::Comma, "comma", "Comma", "a,b,c"},
            schema::Named<Separator>{Separator::Semicolon, "semicolon", "Semicolon", "a;b;c"},
            schema::Named<Separator>{Separator::Tab, "tab", "Tab", "Columns set by tabs."},
            schema::Named<Separator>{Separator::Spaces, "spaces", "Spaces", "Any number of them."},
            schema::Named<Separator>{Separator::Bar, "bar", "Bar", "a|b|c"}});
  b.choice("decimalMark", &L::decimalMark, "Decimal mark",
           {schema::Named<DecimalMark>{DecimalMark::Point, "point", "Point", "0.25"},
            schema::Named<DecimalMark>{DecimalMark::Comma, "comma", "Comma", "0,25"}});
  b.integer("headerLine", &L::headerLine, "Line of names")
      .range(schema::atLeast(0), schema::upTo(1e6))
      .help("Number of the line that names the columns; 0 if none does.");
  b.integer("skippedLines", &L::skippedLines, "Lines to skip")
      .range(schema::atLeast(0), schema::upTo(1e6))
      .help(
          "Lines between the names and the first row that are left out, such as a line of units.");
  b.text("comment", &L::comment, "Comment mark").help("Lines that begin with this are left out.");
}

void Describe<ColumnMapping>::fields(schema::Builder<ColumnMapping>& b) {
  using M = ColumnMapping;
  b.title("column", "Column", "What a column of a measured table is.");
  b.text("column", &M::column, "Column");
  b.text("quantity", &M::quantity, "Quantity").help("Empty for a column that is left out.");
  b.text("unit", &M::unit, "Unit");
  b.text("channel", &M::channel, "Name").help("For a quantity that is not in the list.");
  b.number("scale", &M::scale, "Scale", "", "1")
      .help("The number in the file is multiplied by this before its unit is applied.");
  b.number("offset", &M::offset, "Offset", "", "1")
      .help("Added after the scale, before the unit is applied.");
}

void Describe<ImportSettings>::fields(schema::Builder<ImportSettings>& b) {
  using S = ImportSettings;
  b.title("import", "Import", "How a table of measurements is read.");
  b.group("layout", &S::layout, "Layout");
  b.choice("group", &S::group, "Compare with",
           {schema::Named<ChannelGroup>{ChannelGroup::Run, "run", "Runs over time", ""},
            schema::Named<ChannelGroup>{ChannelGroup::OverThrottle, "over-throttle",
                                        "Steady points over the throttle", ""},
            schema::Named<ChannelGroup>{ChannelGroup::OverAdvance, "over-advance",
                                        "Propeller over the advance ratio", ""}});
  b.list("columns", &S::columns, "Columns");
}

}  // namespace rotorbench
