//! The check that a record carries no NaN and no infinity.
//!
//! JSON has no word for them and writes null, which here means that a number is not known. So every
//! record is walked once before it is written, and the first number that is not finite is named by
//! its full key, `rows[3].relative_error`. An optional number that is absent stays null.
//!
//! The walk is a [`Serializer`] that writes nothing; keys are put together only where it fails,
//! from the inside out.

use crate::report::ReportError;
use serde::ser::{self, Serialize, Serializer};
use std::fmt::{self, Display};

/// Refuses a record with a number that is NaN or infinite.
///
/// # Errors
/// [`ReportError::NotFinite`] with the number's key; [`ReportError::Json`] if the record cannot be
/// serialised at all.
pub(crate) fn check(record: &(impl Serialize + ?Sized)) -> Result<(), ReportError> {
    record.serialize(Walk).map_err(ReportError::from)
}

/// Refuses such a number in an entry of a list.
///
/// # Errors
/// The errors of [`check`]; the key begins with the list's and the entry's place.
pub(crate) fn check_entry(
    list: &str,
    index: usize,
    entry: &(impl Serialize + ?Sized),
) -> Result<(), ReportError> {
    let checked = entry.serialize(Walk);
    checked.map_err(|fault| fault.inside(&format!("{list}[{index}]")).into())
}

/// A number that is not finite, under the key found so far; or what else went wrong.
#[derive(Debug)]
enum Fault {
    NotFinite(String),
    Other(String),
}

impl Fault {
    /// The fault, seen from around the entry with this key.
    fn inside(self, outer: &str) -> Self {
        match self {
            Self::NotFinite(key) if key.is_empty() || key.starts_with('[') => {
                Self::NotFinite(format!("{outer}{key}"))
            }
            Self::NotFinite(key) => Self::NotFinite(format!("{outer}.{key}")),
            other @ Self::Other(_) => other,
        }
    }
}

impl Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite(key) => write!(f, "{key} is not finite"),
            Self::Other(message) => f.write_str(message),
        }
    }
}

impl std::error::Error for Fault {}

impl ser::Error for Fault {
    fn custom<T: Display>(message: T) -> Self {
        Self::Other(message.to_string())
    }
}

impl From<Fault> for ReportError {
    fn from(fault: Fault) -> Self {
        match fault {
            Fault::NotFinite(key) => Self::NotFinite { key },
            Fault::Other(message) => Self::Json(ser::Error::custom(message)),
        }
    }
}

/// The walk, at one value.
struct Walk;

/// The walk through the entries of a list or a map.
#[derive(Default)]
struct Entries {
    /// Place of the next entry of a list.
    next: usize,
    /// Key of the next entry of a map.
    key: String,
    /// The variant of an enumeration that the entries belong to.
    variant: Option<&'static str>,
}

impl Entries {
    fn of_variant(variant: &'static str) -> Self {
        Self {
            variant: Some(variant),
            ..Self::default()
        }
    }

    fn entry(&mut self, value: &(impl Serialize + ?Sized)) -> Result<(), Fault> {
        let place = self.next;
        self.next += 1;
        let checked = value.serialize(Walk);
        checked.map_err(|fault| self.inside(fault.inside(&format!("[{place}]"))))
    }

    fn field(&self, name: &str, value: &(impl Serialize + ?Sized)) -> Result<(), Fault> {
        let checked = value.serialize(Walk);
        checked.map_err(|fault| self.inside(fault.inside(name)))
    }

    fn inside(&self, fault: Fault) -> Fault {
        match self.variant {
            Some(variant) => fault.inside(variant),
            None => fault,
        }
    }
}

fn finite(value: f64) -> Result<(), Fault> {
    if value.is_finite() {
        Ok(())
    } else {
        Err(Fault::NotFinite(String::new()))
    }
}

/// Values that carry no number, or one that is always finite.
macro_rules! passed {
    ($($name:ident($kind:ty);)*) => {
        $(fn $name(self, _: $kind) -> Result<(), Fault> {
            Ok(())
        })*
    };
}

impl Serializer for Walk {
    type Ok = ();
    type Error = Fault;
    type SerializeSeq = Entries;
    type SerializeTuple = Entries;
    type SerializeTupleStruct = Entries;
    type SerializeTupleVariant = Entries;
    type SerializeMap = Entries;
    type SerializeStruct = Entries;
    type SerializeStructVariant = Entries;

    passed! {
        serialize_bool(bool);
        serialize_i8(i8);
        serialize_i16(i16);
        serialize_i32(i32);
        serialize_i64(i64);
        serialize_u8(u8);
        serialize_u16(u16);
        serialize_u32(u32);
        serialize_u64(u64);
        serialize_char(char);
        serialize_str(&str);
        serialize_bytes(&[u8]);
        serialize_unit_struct(&'static str);
    }

    fn serialize_f32(self, value: f32) -> Result<(), Fault> {
        finite(value.into())
    }

    fn serialize_f64(self, value: f64) -> Result<(), Fault> {
        finite(value)
    }

    fn serialize_none(self) -> Result<(), Fault> {
        Ok(())
    }

    fn serialize_some<T: Serialize + ?Sized>(self, value: &T) -> Result<(), Fault> {
        value.serialize(self)
    }

    fn serialize_unit(self) -> Result<(), Fault> {
        Ok(())
    }

    fn serialize_unit_variant(self, _: &str, _: u32, _: &str) -> Result<(), Fault> {
        Ok(())
    }

    fn serialize_newtype_struct<T: Serialize + ?Sized>(
        self,
        _: &str,
        value: &T,
    ) -> Result<(), Fault> {
        value.serialize(self)
    }

    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &str,
        _: u32,
        variant: &str,
        value: &T,
    ) -> Result<(), Fault> {
        Entries::default().field(variant, value)
    }

    fn serialize_seq(self, _: Option<usize>) -> Result<Entries, Fault> {
        Ok(Entries::default())
    }

    fn serialize_tuple(self, _: usize) -> Result<Entries, Fault> {
        Ok(Entries::default())
    }

    fn serialize_tuple_struct(self, _: &str, _: usize) -> Result<Entries, Fault> {
        Ok(Entries::default())
    }

    fn serialize_tuple_variant(
        self,
        _: &str,
        _: u32,
        variant: &'static str,
        _: usize,
    ) -> Result<Entries, Fault> {
        Ok(Entries::of_variant(variant))
    }

    fn serialize_map(self, _: Option<usize>) -> Result<Entries, Fault> {
        Ok(Entries::default())
    }

    fn serialize_struct(self, _: &str, _: usize) -> Result<Entries, Fault> {
        Ok(Entries::default())
    }

    fn serialize_struct_variant(
        self,
        _: &str,
        _: u32,
        variant: &'static str,
        _: usize,
    ) -> Result<Entries, Fault> {
        Ok(Entries::of_variant(variant))
    }
}

/// Lists of every kind.
macro_rules! lists {
    ($($kind:ident::$method:ident;)*) => {
        $(impl ser::$kind for Entries {
            type Ok = ();
            type Error = Fault;

            fn $method<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Fault> {
                self.entry(value)
            }

            fn end(self) -> Result<(), Fault> {
                Ok(())
            }
        })*
    };
}

lists! {
    SerializeSeq::serialize_element;
    SerializeTuple::serialize_element;
    SerializeTupleStruct::serialize_field;
    SerializeTupleVariant::serialize_field;
}

/// Records of every kind.
macro_rules! records {
    ($($kind:ident;)*) => {
        $(impl ser::$kind for Entries {
            type Ok = ();
            type Error = Fault;

            fn serialize_field<T: Serialize + ?Sized>(
                &mut self,
                name: &'static str,
                value: &T,
            ) -> Result<(), Fault> {
                self.field(name, value)
            }

            fn end(self) -> Result<(), Fault> {
                Ok(())
            }
        })*
    };
}

records! {
    SerializeStruct;
    SerializeStructVariant;
}

impl ser::SerializeMap for Entries {
    type Ok = ();
    type Error = Fault;

    fn serialize_key<T: Serialize + ?Sized>(&mut self, key: &T) -> Result<(), Fault> {
        let key = serde_json::to_value(key).map_err(ser::Error::custom)?;
        self.key = key.as_str().map_or_else(|| key.to_string(), str::to_owned);
        Ok(())
    }

    fn serialize_value<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Fault> {
        self.field(&self.key, value)
    }

    fn end(self) -> Result<(), Fault> {
        Ok(())
    }
}
